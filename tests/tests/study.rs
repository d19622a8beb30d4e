//! Schemes under study: which are the same map, what they conserve, how far they are from the exact motion.
#![allow(confusable_idents, reason = "model files spell names as papers do")]

use residua_tools::study::Case;
use residua_tools::study::Decay;
use residua_tools::study::Kept;
use residua_tools::study::Map;
use residua_tools::study::Method;
use residua_tools::study::SCENES;
use residua_tools::study::Scene;
use residua_tools::study::conservation;
use residua_tools::study::same_maps;
use residua_tools::study::schemes;

/// `planar_group` with other names and other rows, its equations scaled and in another order.
mod renamed {
    use residua::model;
    model! {
        param m: kg = 2;
        param J: kg*m^2 = 0.48;
        param l: m = 0.6;
        param g: m/s^2 = 9.81;
        state second: [2];
        state spin: rad/s;
        state first: [2];
        flow {
            der(second) = -S(spin)*second;
            J*der(spin) = -m*g*l*second.x;
            der(first) = -S(spin)*first;
        }
        residual {
            1000*(Δfirst + h*S(spin[k+1/2])*first[k+1/2]) = 0;
            -3*J*Δspin = 3*h*m*g*l*second[k+1/2].x;
            Δsecond/7 = -h*S(spin[k+1/2])*second[k+1/2]/7;
        }
        solve for increment;
        start { first = [1, 0]; second = [0, 1]; spin = 1; }
        invariant total: J = J*spin^2/2 - m*g*l*second.y;
    }
}

/// The same with the attitude of the old state in the last equation: first order, and another map.
mod other {
    use residua::model;
    model! {
        param m: kg = 2;
        param J: kg*m^2 = 0.48;
        param l: m = 0.6;
        param g: m/s^2 = 9.81;
        state spin: rad/s;
        state second: [2];
        flow {
            J*der(spin) = -m*g*l*second.x;
            der(second) = -S(spin)*second;
        }
        residual {
            J*Δspin = -h*m*g*l*second.x;
            Δsecond = -h*S(spin[k+1/2])*second[k+1/2];
        }
        solve for increment;
        start { second = [0, 1]; spin = 1; }
        invariant total: J = J*spin^2/2 - m*g*l*second.y;
    }
}

fn scene(name: &str) -> &'static Scene {
    let found = SCENES.iter().find(|scene| scene.name == name);
    found.unwrap_or_else(|| panic!("no scene {name}"))
}

/// The members of each class, `model form`.
fn classes(maps: &[Map]) -> Vec<Vec<String>> {
    let firsts = maps.iter().enumerate().filter(|(i, map)| map.class == *i);
    let members = |class: usize| {
        let own = maps.iter().filter(|map| map.class == class);
        own.map(|map| format!("{} {}", map.model, map.form))
            .collect()
    };
    firsts.map(|(class, _)| members(class)).collect()
}

#[test]
#[cfg_attr(debug_assertions, ignore = "follows many accurate solutions")]
fn the_papers_schemes_are_five_maps() {
    let planar = scene("planar-large");
    assert_eq!(
        classes(&same_maps(&planar.cases(), planar.until)),
        [
            vec![
                "planar_algebra next",
                "planar_algebra increment",
                "planar_angle next",
                "planar_angle increment"
            ],
            vec!["planar_cayley next", "planar_cayley increment"],
            vec![
                "planar_group next",
                "planar_group increment",
                "planar_recursive increment",
                "planar_reduced next",
                "planar_reduced increment"
            ],
        ]
    );
    let spatial = scene("spatial-asymmetric");
    let groups = classes(&same_maps(&spatial.cases(), spatial.until));
    let groups = groups.iter().filter(|group| group.len() > 2);
    assert_eq!(
        groups.collect::<Vec<_>>(),
        [&[
            "spatial_group increment",
            "spatial_recursive increment",
            "spatial_reduced next",
            "spatial_reduced increment"
        ]]
    );
}

#[test]
#[cfg_attr(debug_assertions, ignore = "follows many accurate solutions")]
fn names_and_scalings_do_not_matter() {
    let scene = scene("planar-large");
    let mut cases = scene.cases();
    cases.retain(|case| case.model.description.name == "planar_group");
    cases.extend([&renamed::MODEL, &other::MODEL].map(|model| scene.set(model)));
    let maps = same_maps(&cases, scene.until);
    let classes: Vec<usize> = maps.iter().map(|map| map.class).collect();
    assert_eq!(classes, [0, 0, 0, 3]);
    // ω, both rows of R and the sine and cosine that the angle adds.
    let (_, shared) = maps[2].differences[0].unwrap();
    assert!(shared >= 5, "{shared} signals");
}

/// What becomes of the first invariant of a model.
fn kept(case: &Case) -> Kept {
    let method = Method::of(case.model)[0];
    conservation(case, method, 0.01, 200).unwrap()[0].kept
}

#[test]
#[cfg_attr(debug_assertions, ignore = "takes many steps")]
fn conservation_is_found_whatever_the_names() {
    let scene = scene("planar-large");
    assert_eq!(kept(&scene.set(&renamed::MODEL)), Kept::Exactly);
    let Kept::ToOrder(order) = kept(&scene.set(&other::MODEL)) else {
        panic!("an explicit weight keeps the energy to first order");
    };
    assert!((0.8..1.2).contains(&order), "{order}");
    for case in scene.cases() {
        match case.model.description.name {
            "planar_group" | "planar_reduced" | "planar_recursive" => {
                assert_eq!(kept(&case), Kept::Exactly);
            }
            name => {
                let Kept::ToOrder(order) = kept(&case) else {
                    panic!("{name}");
                };
                assert!((order - 2.0).abs() < 0.05, "{name}: {order}");
            }
        }
    }
}

#[test]
fn an_error_that_stays_does_not_vanish() {
    assert!(!Decay::new(&[1e-3, 1e-3], 1e-12).vanishes());
    assert!(!Decay::new(&[f64::INFINITY; 3], f64::INFINITY).vanishes());
    assert!(!Decay::new(&[1e-3, f64::NAN], 1e-12).vanishes());
    assert!(Decay::new(&[1e-3, 5e-4], 1e-12).vanishes());
    assert!(Decay::new(&[1e-3, 1e-13], 1e-12).vanishes());
}

/// A small swing of frequency κ has the discrete frequency κ (1 − (κh)²/12 + …) under the midpoint rule, so after
/// T it lags T (κh)²/12; an amplitude of 0.2 rad changes that by a hundredth.
#[test]
#[cfg_attr(debug_assertions, ignore = "takes many steps")]
fn the_midpoint_rule_lags_as_theory_says() {
    let scene = scene("planar-paper");
    let reference = scene.of_reference().unwrap();
    let exact = scene.exact_end(&reference).unwrap();
    let rows = schemes(scene, &exact).unwrap();
    let kappa_squared = 2.0 * 9.81 * 0.6 / 0.48;
    let lag = scene.until * kappa_squared * scene.h * scene.h / 12.0;
    for row in rows {
        let found = row.found.unwrap();
        let what = format!("{} {}", row.model, row.method);
        if row.method == "RK4" {
            assert!((found.order - 4.0).abs() < 0.05, "{what}: {}", found.order);
        } else {
            assert!((found.order - 2.0).abs() < 0.01, "{what}: {}", found.order);
            let ahead = found.ahead.unwrap();
            assert!((ahead + lag).abs() < 0.02 * lag, "{what}: {ahead}, {lag}");
        }
    }
}
