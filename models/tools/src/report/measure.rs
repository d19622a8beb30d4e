//! How far a run is from the exact solution: difference, lag, amplitude, energy.

use super::reference::Planar;
use super::reference::Plane;
use super::reference::Spatial;
use super::runs::Recording;
use super::runs::RunError;
use super::runs::Wanted;

/// Two curves coincide while their difference is below this share of the range of the figure: a hundredth
/// of the height of a plot is the width of its lines.
pub const COINCIDE: f64 = 0.01;

/// Length of the windows at the start and the end that the paper shows, s.
pub const WINDOW: f64 = 5.0;

/// Sampled times may be this far outside a window by rounding, s.
pub const SLACK: f64 = 1e-9;

fn largest(values: &[f64]) -> f64 {
    values.iter().copied().fold(0.0, f64::max)
}

/// A swing: its angle and the rate of it, at the times of a run.
pub struct Swing {
    times: Vec<f64>,
    angles: Vec<f64>,
    rates: Vec<f64>,
}

/// A run against the exact solution.
pub struct Measure {
    /// The run.
    pub run: Wanted,
    /// Peak to peak of the exact angle, rad.
    pub range: f64,
    /// Largest difference of the angle in the first 5 s, rad.
    pub first: f64,
    /// Largest difference of the angle in the last 5 s, rad.
    pub last: f64,
    /// Up to when the curves coincide, s.
    pub coincides_until: f64,
    /// How much later than in the exact solution the last full swing ends, s.
    pub lag: f64,
    /// Swings of the exact solution.
    pub swings: usize,
    /// Of a swing of the exact solution, s.
    pub period: f64,
    /// Change of the amplitude from the start to the last 5 s, a share of it.
    pub amplitude_change: f64,
    /// Largest departure of the energy from its start, as a share of what the swing has above rest.
    pub energy_error: f64,
    /// Largest part of ω across the axis of the exact swing, as a share of the largest ω; 0 in the plane.
    pub off_axis: f64,
    /// Up to when that part is below [`COINCIDE`], s.
    pub on_axis_until: f64,
    /// Newton iterations per step.
    pub iterations: f64,
}

impl Measure {
    /// Measures a run.
    pub fn of(run: &Wanted, made: &Recording, exact: &Recording) -> Result<Self, RunError> {
        let (own, true_one) = match run.is_planar() {
            true => (Swing::planar(made)?, Swing::planar(exact)?),
            false => (
                Swing::tilt(made, &vertical(run, made)?)?,
                Swing::tilt(exact, &vector(exact, "Γ3")?)?,
            ),
        };
        let amplitudes = amplitudes(run, made)?;
        let amplitude = amplitudes.first().copied().unwrap_or(0.0);
        let range = 2.0 * amplitude;
        let end = made.times.last().copied().unwrap_or(0.0);
        let differences: Vec<f64> = own.differences(&true_one);
        let within = |values: &[f64], from: f64, to: f64| -> Vec<f64> {
            let inside = made.times.iter().zip(values);
            let inside = inside.filter(|(t, _)| (from - SLACK..=to + SLACK).contains(*t));
            inside.map(|(_, value)| *value).collect()
        };
        let first_above = |values: &[f64], limit: f64| {
            let above = values.iter().position(|value| *value > limit);
            above.map_or(end, |i| made.times[i])
        };
        let late = within(&amplitudes, end - WINDOW, end);
        let late_amplitude = late.iter().sum::<f64>() / late.len().max(1) as f64;
        let (lag, swings) = own.lag(&true_one);
        let off_axis = match run.is_planar() {
            true => Vec::new(),
            false => off_axis(made, &vertical(run, made)?)?,
        };
        Ok(Self {
            run: *run,
            range,
            first: largest(&within(&differences, 0.0, WINDOW)),
            last: largest(&within(&differences, end - WINDOW, end)),
            coincides_until: first_above(&differences, COINCIDE * range),
            lag,
            swings,
            period: true_one.period(),
            amplitude_change: late_amplitude / amplitude - 1.0,
            energy_error: energy_error(made, scene(run)?)?,
            off_axis: largest(&off_axis),
            on_axis_until: first_above(&off_axis, COINCIDE),
            iterations: made.iterations,
        })
    }

    /// Largest difference of the angle in the last 5 s, as a share of the range.
    pub fn last_share(&self) -> f64 {
        self.last / self.range
    }

    /// The same in the first 5 s.
    pub fn first_share(&self) -> f64 {
        self.first / self.range
    }

    /// When the plane of the swing is first off by [`COINCIDE`], s; `None` if it never is.
    pub fn plane_lost(&self) -> Option<f64> {
        (self.off_axis > COINCIDE).then_some(self.on_axis_until)
    }
}

/// Largest departure of the energy from its start, as a share of what the swing has above rest.
fn energy_error(made: &Recording, scene: Planar) -> Result<f64, RunError> {
    let energies = made.values("energy")?;
    let start = energies.first().copied().unwrap_or(0.0);
    let errors = energies.iter().map(|energy| (energy - start).abs());
    Ok(errors.fold(0.0, f64::max) / (start + scene.torque))
}

/// The amplitude of the swing through the state of a run at each of its times, rad.
pub fn amplitudes(run: &Wanted, made: &Recording) -> Result<Vec<f64>, RunError> {
    let scene = scene(run)?;
    let energies = made.values("energy")?;
    Ok(energies
        .iter()
        .map(|energy| scene.amplitude(*energy))
        .collect())
}

fn scene(run: &Wanted) -> Result<Planar, RunError> {
    match run.is_planar() {
        true => Planar::paper(),
        false => Ok(Spatial::paper()?.swing),
    }
}

/// The part of ω across the axis of the exact swing, as a share of the largest ω, at each time.
fn off_axis(made: &Recording, vertical: &Vectors) -> Result<Vec<f64>, RunError> {
    let axis = plane(vertical).axis;
    let [x, y, z] = vector(made, "ω")?;
    let (mut across, mut largest) = (Vec::new(), 0.0_f64);
    for ((x, y), z) in x.iter().zip(&y).zip(&z) {
        let omega = [*x, *y, *z];
        let along: f64 = omega.iter().zip(&axis).map(|(o, a)| o * a).sum();
        let rest = [0, 1, 2].map(|i| omega[i] - along * axis[i]);
        let size = |v: [f64; 3]| v.iter().map(|c| c * c).sum::<f64>().sqrt();
        across.push(size(rest));
        largest = largest.max(size(omega));
    }
    Ok(across.into_iter().map(|part| part / largest).collect())
}

/// The components of a vector at each time.
type Vectors = [Vec<f64>; 3];

/// The vertical in the body frame, by the name that a model gives it.
fn vertical(run: &Wanted, made: &Recording) -> Result<Vectors, RunError> {
    match run.model {
        "spatial_recursive" => vector(made, "vertical"),
        "spatial_reduced" => vector(made, "Γ"),
        // The last row of the matrix.
        "spatial_cardan" | "spatial_cardan_zyx" => Ok([
            made.values("attitude.31")?,
            made.values("attitude.32")?,
            made.values("attitude.33")?,
        ]),
        _ => vector(made, "Γ3"),
    }
}

/// The plane of the swing from where a run starts.
fn plane([x, y, z]: &Vectors) -> Plane {
    let first = |component: &[f64]| component.first().copied().unwrap_or(f64::NAN);
    Plane::of([first(x), first(y), first(z)])
}

fn vector(made: &Recording, name: &str) -> Result<Vectors, RunError> {
    let component = |axis: &str| made.values(&format!("{name}.{axis}"));
    Ok([component("x")?, component("y")?, component("z")?])
}

impl Swing {
    fn planar(made: &Recording) -> Result<Self, RunError> {
        Ok(Self {
            times: made.times.clone(),
            angles: made.values("θ")?,
            rates: made.values("ω")?,
        })
    }

    fn tilt(made: &Recording, vertical: &Vectors) -> Result<Self, RunError> {
        let plane = plane(vertical);
        let [x, y, z] = vertical;
        let omega = vector(made, "ω")?;
        let (mut angles, mut rates) = (Vec::new(), Vec::new());
        for i in 0..made.times.len() {
            let omega = [omega[0][i], omega[1][i], omega[2][i]];
            let (angle, rate) = plane.tilt([x[i], y[i], z[i]], omega);
            angles.push(angle);
            rates.push(rate);
        }
        Ok(Self {
            times: made.times.clone(),
            angles,
            rates,
        })
    }

    fn differences(&self, other: &Self) -> Vec<f64> {
        let pairs = self.angles.iter().zip(&other.angles);
        pairs.map(|(own, other)| (own - other).abs()).collect()
    }

    /// How much later than in `other` the last swing that both complete ends, and the swings of `other`.
    fn lag(&self, other: &Self) -> (f64, usize) {
        let (own, others) = (self.ends(), other.ends());
        let last = own.len().min(others.len());
        let lag = match last.checked_sub(1) {
            Some(i) => own[i] - others[i],
            None => 0.0,
        };
        (lag, others.len())
    }

    /// Mean time from the end of a swing to that of the next.
    fn period(&self) -> f64 {
        let ends = self.ends();
        match &ends[..] {
            [first, .., last] => (last - first) / (ends.len() - 1) as f64,
            _ => f64::NAN,
        }
    }

    /// Times at which the angle passes 0 upwards, by the cubic through angle and rate on both sides.
    fn ends(&self) -> Vec<f64> {
        let upwards = |i: &usize| self.angles[*i] < 0.0 && self.angles[*i + 1] >= 0.0;
        let intervals = (0..self.times.len().saturating_sub(1)).filter(upwards);
        intervals.map(|i| self.zero(i)).collect()
    }

    fn zero(&self, i: usize) -> f64 {
        let h = self.times[i + 1] - self.times[i];
        let (a, b) = (self.angles[i], self.angles[i + 1]);
        let (u, v) = (h * self.rates[i], h * self.rates[i + 1]);
        let cubic = |s: f64| {
            let (c, d) = (3.0 * (b - a) - 2.0 * u - v, 2.0 * (a - b) + u + v);
            a + s * (u + s * (c + s * d))
        };
        let (mut low, mut high) = (0.0, 1.0);
        for _ in 0..BISECTIONS {
            let middle = (low + high) / 2.0;
            if cubic(middle) < 0.0 {
                low = middle
            } else {
                high = middle
            }
        }
        self.times[i] + h * (low + high) / 2.0
    }
}

/// Halvings that bring an interval of length 1 below the rounding of its ends.
const BISECTIONS: usize = 54;
