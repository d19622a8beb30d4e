//! Other people's integrators: `cargo test --release -p residua-tools --features rivals --test rivals`.

#![cfg(feature = "rivals")]

use residua_models::rivals::Rival;
use residua_tools::precision::Budget;
use residua_tools::precision::Given;
use residua_tools::precision::Ladders;
use residua_tools::precision::OURS;
use residua_tools::precision::Problem;
use residua_tools::precision::contestants;
use residua_tools::precision::measure;

/// One run of each: the errors count here, not the times.
const ONCE: Budget = Budget {
    runs: 1,
    together: 1.0,
    longest: 1.0,
};

#[test]
fn rivals_end_where_the_motion_ends() {
    for (scene, until) in [
        ("planar-paper", 5.0),
        ("spatial-asymmetric", 1.0),
        ("lattice", 1.0),
    ] {
        let problem = {
            let given = Given::named(scene, Some(until)).unwrap();
            Problem::new(scene, given, &[]).unwrap()
        };
        let ladders = Ladders {
            steps: (1.0, 1.0),
            tolerances: (1e-9, 1e-9),
        };
        let mut all = contestants(&problem, &ladders);
        all.retain(|of| of.by != OURS);
        let rows = measure(&problem, &all, &ONCE, &mut |_, _| {});
        let theirs = rows.iter();
        assert_eq!(
            theirs.clone().count(),
            Rival::ALL.len() * problem.formulations.len()
        );
        for row in theirs {
            // Local errors of 1e-9 add up over the steps. That of radau5 is estimated to order 3 and taken for its error of
            // order 5 (Hairer and Wanner, *Solving Ordinary Differential Equations II*, IV.8), and the crate leaves more of
            // its stage equations than that: 6e-4 in 18 steps of the exponential, where none of the others is off by 1e-5.
            let most = if row.scheme == "radau5" { 1e-3 } else { 1e-5 };
            assert!(row.trajectory <= most, "{row:?}");
            assert!(row.steps > 1 && row.evaluations > row.steps, "{row:?}");
        }
    }
}
