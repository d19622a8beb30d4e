//! The Taylor coefficients of a motion.

use super::MOST_ORDER;
use crate::integration::FlatState;
use crate::model::Record;
use crate::model::Series;
use crate::packed::Arithmetic;
use crate::packed::BEFORE;
use crate::packed::Packed;
use crate::packed::Work;

/// Orders of inner sums, and zeros before and after.
const ROOM: usize = MOST_ORDER + 2 * BEFORE;

/// The Taylor coefficients of one step, and the memory that the recurrences need.
pub struct Expansion<M: Series<T>, T: Packed> {
    scene: <M as Series<T>>::Scene,
    /// xₙ hⁿ
    coefficients: [FlatState<M, T>; MOST_ORDER + 1],
    /// aₙ and bₙ of the inner sums.
    left: [M::Lanes; ROOM],
    right: [M::Lanes; ROOM],
    /// 1/n
    inverse: [T; MOST_ORDER + 1],
    order: usize,
}

impl<M: Series<T>, T: Packed> Expansion<M, T> {
    /// Room for coefficients up to `order`, which is 1 to [`MOST_ORDER`].
    pub fn new(parameters: &M::Parameters, order: usize) -> Self {
        let mut state = M::start(parameters).to_array();
        state.as_mut().fill(T::constant(0.0));
        let one = T::constant(1.0);
        Self {
            scene: <M as Series<T>>::scene(parameters),
            coefficients: [state; MOST_ORDER + 1],
            left: [M::lanes(); ROOM],
            right: [M::lanes(); ROOM],
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
    pub fn expand(&mut self, t: T, x: &FlatState<M, T>, h: T) {
        T::work(Recurrences {
            expansion: self,
            t,
            x,
            h,
        });
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

/// The recurrences of one step, for [`Packed::work`].
struct Recurrences<'a, M: Series<T>, T: Packed> {
    expansion: &'a mut Expansion<M, T>,
    t: T,
    x: &'a FlatState<M, T>,
    h: T,
}

impl<M: Series<T>, T: Packed> Work<T> for Recurrences<'_, M, T> {
    type Output = ();

    #[inline(always)]
    fn run<A: Arithmetic<T>>(self, arithmetic: A) {
        let Self { expansion, t, x, h } = self;
        let zero = T::constant(0.0);
        let base = M::base(&expansion.scene, t, x);
        let mut rates = M::rates(&expansion.scene, &base);
        let mut first = [M::lanes(); 2];
        let mut last = first;
        expansion.coefficients[0] = *x;
        for n in 1..=expansion.order {
            let inverse = expansion.inverse[n];
            let unit = h * inverse;
            let mut newest = rates;
            for x in newest.as_mut() {
                *x = unit * *x;
            }
            expansion.coefficients[n] = newest;
            if n == expansion.order {
                return;
            }
            // What is newest comes last, so that the others need not wait for it.
            let mut sums = arithmetic.inner(&expansion.left, &expansion.right, n);
            if n > 1 {
                sums = arithmetic.multiply_add(&first[0], &last[1], &sums);
            }
            if n > 2 {
                sums = arithmetic.multiply_add(&last[0], &first[1], &sums);
            }
            let time = if n == 1 { h } else { zero };
            let order = [time, T::constant(n as f64), inverse];
            let next = M::next(&expansion.scene, &base, &newest, &order, &sums);
            rates = next.0;
            last = [next.1, next.2];
            if n == 1 {
                first = last;
            } else {
                expansion.left[n] = last[0];
                expansion.right[n + BEFORE] = last[1];
            }
        }
    }
}
