#![allow(missing_docs)]
use residua::{Ensemble, Fleet, Model, Record, Settings, System, Wide};
use residua_models::dsl as models;
use std::time::Instant;
fn go<S: Wide + 'static>(name: &str, steps: u64, every: u64) {
    let fill = |i: usize, p: &mut [f64], s: &mut [f64]| {
        let par = <<S as System<f64>>::Model as Model<f64>>::Parameters::default();
        s.copy_from_slice(<S as System<f64>>::Model::start(&par).to_array().as_ref());
        p.copy_from_slice(par.to_array().as_ref());
        s[0] += 1e-3 * i as f64;
    };
    let n = 64;
    let obs = |_: usize, _: residua::erased::Sample| {};
    let fleet = Fleet { trajectories: 0..n, fill: &fill, h: 0.01, t0: 0.0, steps, every, settings: Settings::default(), observer: &obs };
    let pool = rayon::ThreadPoolBuilder::new().num_threads(1).build().unwrap();
    let t = Instant::now();
    let out = pool.install(|| Ensemble::<S>::NEW.fly(&fleet)).unwrap();
    let dt = t.elapsed().as_secs_f64() * 1e9 / (n as f64 * steps as f64);
    let it: u64 = out.iter().map(|o| o.statistics.iterations).sum();
    let al: u64 = out.iter().map(|o| o.alone).sum();
    let err = out.iter().filter(|o| o.error.is_some()).count();
    println!("{name}: {dt:.2} ns/step/traj, {:.3} iterations, alone {:.4}, errors {err}", it as f64 / (n as f64 * steps as f64), al as f64 / (n as f64 * steps as f64));
}
fn main() {
    let only = std::env::args().nth(1).unwrap_or_default();
    let steps: u64 = std::env::args().nth(2).and_then(|s| s.parse().ok()).unwrap_or(20000);
    macro_rules! g { ($($m:ident $f:ident),*) => { $( let name = concat!(stringify!($m), " ", stringify!($f)); if name.contains(&only) { go::<models::$m::$f>(name, steps, 0); } )* } }
    g!(planar_angle Next, planar_angle Increment, planar_reduced Next, planar_reduced Increment, planar_recursive Increment, planar_group Next, planar_group Increment, planar_algebra Increment, planar_cayley Increment, spatial_recursive Increment, spatial_reduced Next, spatial_reduced Increment, spatial_group Increment, spatial_cardan Increment, spatial_cardan_zyx Increment, spatial_exponential Increment, spatial_variational Increment, spherical Increment, double_planar Increment, elastic Increment);
}
