use super::steps;

#[test]
fn decimal_steps_are_counted_as_meant() {
    for (step, until, expected) in [(0.1, 0.3, 3), (0.01, 100.0, 10_000), (1e-3, 50.0, 50_000)] {
        let span = steps(step, until).unwrap();
        assert_eq!((span.steps, span.note), (expected, None), "{step} {until}");
    }
}

#[test]
fn an_end_between_two_steps_is_announced() {
    let span = steps(0.3, 1.0).unwrap();
    assert_eq!(span.steps, 3);
    assert!(span.note.unwrap().contains("ends at t = 0.9"));
}

#[test]
fn nonsense_is_refused() {
    for (step, until) in [
        (0.0, 1.0),
        (-0.1, 1.0),
        (f64::NAN, 1.0),
        (0.1, f64::INFINITY),
        (0.1, -1.0),
        (0.1, 0.05),
        (1e-300, 1.0),
    ] {
        assert!(steps(step, until).is_err(), "{step} {until}");
    }
}
