//! The explicit pair of Dormand and Prince.

use super::Attempt;
use super::Tolerance;
use super::Variable;
use super::controlled::Adaptive;
use super::gauss::zeros;
use super::rates;
use crate::error::Fault;
use crate::integration::FlatState;
use crate::integration::require_finite;
use crate::model::Flow;
use crate::model::Model;
use crate::report::Statistics;
use crate::scalar::Real;

/// A run of the continuous equations by the explicit pair of orders 5 and 4 with seven stages, the last of which is the
/// first of the next step, and dense output of order 4. Linear invariants are kept.
///
/// Source: Dormand and Prince (1980); Hairer, Nørsett and Wanner, *Solving Ordinary Differential Equations I*, table 5.2;
/// dense output by Shampine (1986), there equation II.6.12 and the code DOPRI5.
pub type DormandPrince5<M, T = f64> = Adaptive<Pair<M, T>, T>;

/// The scheme of a [`DormandPrince5`].
pub struct Pair<M: Flow<T>, T: Real> {
    scene: M::FlowScene,
    /// k₁ of the next step, if it is known.
    first: Option<FlatState<M, T>>,
    /// Of the step that was tried: its start, its end, its rates, its length.
    start: FlatState<M, T>,
    end: FlatState<M, T>,
    rates: [FlatState<M, T>; 7],
    h: T,
    /// Of the accepted step: coefficients of its polynomial.
    dense: [FlatState<M, T>; 5],
}

const NODES: [f64; 7] = [0.0, 1.0 / 5.0, 3.0 / 10.0, 4.0 / 5.0, 8.0 / 9.0, 1.0, 1.0];

const STAGES: [[f64; 6]; 6] = [
    [1.0 / 5.0, 0.0, 0.0, 0.0, 0.0, 0.0],
    [3.0 / 40.0, 9.0 / 40.0, 0.0, 0.0, 0.0, 0.0],
    [44.0 / 45.0, -56.0 / 15.0, 32.0 / 9.0, 0.0, 0.0, 0.0],
    [
        19372.0 / 6561.0,
        -25360.0 / 2187.0,
        64448.0 / 6561.0,
        -212.0 / 729.0,
        0.0,
        0.0,
    ],
    [
        9017.0 / 3168.0,
        -355.0 / 33.0,
        46732.0 / 5247.0,
        49.0 / 176.0,
        -5103.0 / 18656.0,
        0.0,
    ],
    [
        35.0 / 384.0,
        0.0,
        500.0 / 1113.0,
        125.0 / 192.0,
        -2187.0 / 6784.0,
        11.0 / 84.0,
    ],
];

/// b − b̂
const ERROR: [f64; 7] = [
    71.0 / 57600.0,
    0.0,
    -71.0 / 16695.0,
    71.0 / 1920.0,
    -17253.0 / 339_200.0,
    22.0 / 525.0,
    -1.0 / 40.0,
];

const DENSE: [f64; 7] = [
    -12_715_105_075.0 / 11_282_082_432.0,
    0.0,
    87_487_479_700.0 / 32_700_410_799.0,
    -10_690_763_975.0 / 1_880_347_072.0,
    701_980_252_875.0 / 199_316_789_632.0,
    -1_453_857_185.0 / 822_651_844.0,
    69_997_945.0 / 29_380_423.0,
];

impl<M: Flow<T>, T: Real> Variable<T> for Pair<M, T> {
    type Model = M;

    fn new(parameters: &<M as Model<T>>::Parameters) -> Self {
        let zeros = zeros::<M, T>();
        Self {
            scene: M::flow_scene(parameters),
            first: None,
            start: zeros,
            end: zeros,
            rates: [zeros; 7],
            h: T::constant(0.0),
            dense: [zeros; 5],
        }
    }

    fn order(&self) -> usize {
        5
    }

    fn attempt(
        &mut self,
        t: T,
        x: &FlatState<M, T>,
        h: T,
        tolerance: &Tolerance<T>,
        statistics: &mut Statistics,
    ) -> Result<Attempt<T>, Fault> {
        (self.start, self.h) = (*x, h);
        self.rates[0] = match self.first {
            Some(rate) => rate,
            None => {
                statistics.flows += 1;
                rates::<M, T>(&self.scene, t, x)
            }
        };
        self.first = Some(self.rates[0]);
        let mut at = *x;
        for (i, row) in STAGES.iter().enumerate() {
            at = moved(x, h, row, &self.rates[..=i]);
            let time = t + T::constant(NODES[i + 1]) * h;
            self.rates[i + 1] = rates::<M, T>(&self.scene, time, &at);
        }
        statistics.flows += 6;
        require_finite(&at)?;
        self.end = at;
        let mut error = T::constant(0.0);
        let errors = moved(&zeros::<M, T>(), h, &ERROR, &self.rates);
        let components = errors.as_ref().iter().zip(x.as_ref()).zip(at.as_ref());
        for ((e, x), next) in components {
            let e = e.abs() / tolerance.of(*x, *next);
            // NaN, too.
            error = if error >= e { error } else { e };
        }
        Ok(Attempt {
            error,
            iterations: 0,
        })
    }

    fn accept(&mut self) -> FlatState<M, T> {
        let [k1, .., k7] = &self.rates;
        let (h, bend) = (self.h, moved(&zeros::<M, T>(), self.h, &DENSE, &self.rates));
        for i in 0..bend.as_ref().len() {
            let (x, next) = (self.start.as_ref()[i], self.end.as_ref()[i]);
            let difference = next - x;
            let spline = h * k1.as_ref()[i] - difference;
            let coefficients = [
                x,
                difference,
                spline,
                difference - h * k7.as_ref()[i] - spline,
                bend.as_ref()[i],
            ];
            for (dense, coefficient) in self.dense.iter_mut().zip(coefficients) {
                dense.as_mut()[i] = coefficient;
            }
        }
        self.first = Some(self.rates[6]);
        self.end
    }

    fn at(&self, theta: T) -> FlatState<M, T> {
        let rest = T::constant(1.0) - theta;
        let mut x = self.dense[0];
        let [_, a, b, c, d] = &self.dense;
        for (i, x) in x.as_mut().iter_mut().enumerate() {
            let inner = c.as_ref()[i] + rest * d.as_ref()[i];
            let middle = b.as_ref()[i] + theta * inner;
            *x = *x + theta * (a.as_ref()[i] + rest * middle);
        }
        x
    }

    fn restart(&mut self) {
        self.first = None;
    }
}

/// x + h Σ aⱼ kⱼ
fn moved<T: Real, A: AsRef<[T]> + AsMut<[T]> + Copy>(x: &A, h: T, a: &[f64], k: &[A]) -> A {
    let mut moved = *x;
    for (i, x) in moved.as_mut().iter_mut().enumerate() {
        let terms = a.iter().zip(k);
        let sum = terms.fold(T::constant(0.0), |sum, (a, k)| {
            sum + T::constant(*a) * k.as_ref()[i]
        });
        *x = *x + h * sum;
    }
    moved
}
