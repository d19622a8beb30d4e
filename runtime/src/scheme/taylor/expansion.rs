//! The Taylor coefficients of a motion.

use super::MOST_ORDER;
use crate::integration::FlatState;
use crate::model::Model;
use crate::model::Record;
use crate::model::Series;
use crate::scalar::Scalar;

/// The Taylor coefficients of one step, and the memory that the recurrences need.
pub struct Expansion<M: Series<T>, T: Scalar> {
    scene: <M as Series<T>>::Scene,
    /// xₙ hⁿ
    coefficients: [FlatState<M, T>; MOST_ORDER + 1],
    /// aₙ and bₙ of the inner sums.
    left: [M::Lanes; MOST_ORDER],
    right: [M::Lanes; MOST_ORDER],
    /// 1/n
    inverse: [T; MOST_ORDER + 1],
    order: usize,
}

impl<M: Series<T>, T: Scalar> Expansion<M, T> {
    /// Room for coefficients up to `order`, which is 1 to [`MOST_ORDER`].
    pub fn new(parameters: &M::Parameters, order: usize) -> Self {
        let mut state = M::start(parameters).to_array();
        state.as_mut().fill(T::constant(0.0));
        let one = T::constant(1.0);
        Self {
            scene: <M as Series<T>>::scene(parameters),
            coefficients: [state; MOST_ORDER + 1],
            left: [M::lanes(); MOST_ORDER],
            right: [M::lanes(); MOST_ORDER],
            inverse: core::array::from_fn(|n| one / T::constant(n.max(1) as f64)),
            order: order.clamp(1, MOST_ORDER),
        }
    }

    /// The highest order.
    pub fn order(&self) -> usize {
        self.order
    }

    /// Sets the highest order, 1 to [`MOST_ORDER`].
    pub fn set_order(&mut self, order: usize) {
        self.order = order.clamp(1, MOST_ORDER);
    }

    /// xₙ hⁿ for n = 0, 1, …
    pub fn coefficients(&self) -> &[FlatState<M, T>] {
        &self.coefficients[..=self.order]
    }

    /// Expands the motion through `x` at time `t`, with `h` as the unit of time.
    #[inline]
    pub fn expand(&mut self, t: T, x: &FlatState<M, T>, h: T) {
        let zero = T::constant(0.0);
        let base = M::base(&self.scene, t, x);
        let mut rates = M::rates(&self.scene, &base);
        self.coefficients[0] = *x;
        for n in 1..=self.order {
            let inverse = self.inverse[n];
            let unit = h * inverse;
            let mut newest = rates;
            for x in newest.as_mut() {
                *x = unit * *x;
            }
            self.coefficients[n] = newest;
            if n == self.order {
                return;
            }
            let sums = self.inner_sums(n);
            let time = if n == 1 { h } else { zero };
            let order = [time, T::constant(n as f64), inverse];
            let next = M::next(&self.scene, &base, &newest, &order, &sums);
            (rates, self.left[n], self.right[n]) = next;
        }
    }

    /// Σ aⱼ bₙ₋ⱼ, 0 < j < n
    #[inline(always)]
    fn inner_sums(&self, n: usize) -> M::Lanes {
        let mut sums = M::lanes();
        for j in 1..n {
            let factors = self.left[j].as_ref().iter().zip(self.right[n - j].as_ref());
            for (sum, (a, b)) in sums.as_mut().iter_mut().zip(factors) {
                *sum = *sum + *a * *b;
            }
        }
        sums
    }

    /// What the step adds to the state: Σ xₙ hⁿ, 0 < n, the smallest first.
    #[inline]
    pub fn increment(&self) -> FlatState<M, T> {
        let mut sum = self.coefficients[self.order];
        for coefficient in self.coefficients[1..self.order].iter().rev() {
            for (sum, x) in sum.as_mut().iter_mut().zip(coefficient.as_ref()) {
                *sum = *sum + *x;
            }
        }
        sum
    }
}
