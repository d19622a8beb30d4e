//! The closed form of the free body: against thirty digits, and where the formulae degenerate.

use residua_models::exact::Double;
use residua_models::exact::FreeBody;
use serde_json::Value;

use crate::list;
use crate::text;

static CASE: &str = include_str!("data/free_body.json");

#[test]
fn angular_velocity_near_the_middle_axis_is_the_nearest_to_the_reference() {
    let case: Value = serde_json::from_str(CASE).unwrap();
    let three = |value: &Value| -> [Double; 3] {
        core::array::from_fn(|i| text(&value[i]).parse().unwrap())
    };
    let body = FreeBody::new(three(&case["j"]), three(&case["omega0"])).unwrap();
    for sample in list(&case["samples"]) {
        let expected: [f64; 3] =
            core::array::from_fn(|i| text(&sample["omega"][i]).parse().unwrap());
        assert_eq!(
            body.at(text(&sample["t"]).parse().unwrap()),
            expected,
            "t = {}",
            sample["t"]
        );
    }
    let period: f64 = text(&case["period"]).parse().unwrap();
    assert_eq!(body.period(), Some(period));
}

#[test]
fn steady_turns_stay() {
    for omega0 in [
        [0.0, 0.0, 0.0],
        [2.0, 0.0, 0.0],
        [0.0, -2.0, 0.0],
        [0.0, 0.0, 3.0],
    ] {
        let body = FreeBody::new([1.0, 2.0, 3.0], omega0).unwrap();
        assert_eq!(body.at(17.0), omega0);
        assert_eq!(body.period(), None);
    }
    let ball = FreeBody::new([2.0; 3], [1.0, 2.0, 3.0]).unwrap();
    assert_eq!(ball.at(17.0), [1.0, 2.0, 3.0]);
}

#[test]
fn the_separatrix_ends_on_the_middle_axis() {
    // 2 E J₂ = L²: J₁ (J₂ − J₁) ω₁² = J₃ (J₃ − J₂) ω₃² with 2 · 1 · ω₁² = 6 · 3 · ω₃².
    let body = FreeBody::new([2.0, 3.0, 6.0], [3.0, 0.0, 1.0]).unwrap();
    assert_eq!(body.period(), None);
    let late = body.at(1e4);
    // ω₂ takes all the momentum: L²/J₂² = (4·9 + 36)/9.
    assert_eq!(late, [0.0, late[1], 0.0]);
    assert!((late[1].abs() - 8f64.sqrt()).abs() <= f64::EPSILON * 8f64.sqrt());
}
