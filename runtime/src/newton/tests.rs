//! Newton's method on problems with known roots and known ways to fail.

use crate::Failure;
use crate::Place;
use crate::Settings;
use crate::StepError;
use crate::Stepper;
use crate::Success;
use crate::report::Report;
use crate::specimens::root::Evaluated;
use crate::specimens::root::Flat;
use crate::specimens::root::Problem;
use crate::specimens::root::Root;

fn solve<P: Problem<N>, const N: usize>(
    start: [f64; N],
    settings: Settings,
) -> Result<([f64; N], Report), StepError>
where
    Root<P, N>: crate::Solvable<f64, Unknowns = [f64; N], Model = Root<P, N>>,
{
    let mut stepper = Stepper::<Root<P, N>>::new(Flat([]), Flat(start), 1.0)
        .unwrap()
        .with_settings(settings);
    let report = stepper.step()?;
    Ok((*stepper.state_array(), report))
}

/// x² + y² = 5, x y = 2 with the root (2, 1).
struct Circle;
impl Problem<2> for Circle {
    fn evaluate([x, y]: [f64; 2], _: [f64; 2]) -> Evaluated<2> {
        let r = [x * x + y * y - 5.0, x * y - 2.0];
        (r, [[2.0 * x, 2.0 * y], [y, x]])
    }
}

#[test]
fn corrections_shrink_quadratically() {
    let (root, report) = solve::<Circle, 2>([3.0, 0.5], Settings::default()).unwrap();
    assert!((root[0] - 2.0).abs() < 1e-15 && (root[1] - 1.0).abs() < 1e-15);
    assert_eq!(report.success, Success::Converged);
    assert_eq!(report.iterations, 6);
}
