//! The Taylor coefficients of a motion.

use super::MOST_ORDER;
use crate::convolution::BEFORE;
use crate::convolution::Convolutions;
use crate::convolution::Convolve;
use crate::convolution::Convolved;
use crate::convolution::Rows;
use crate::integration::FlatState;
use crate::model::Record;
use crate::model::Series;

/// Orders of inner sums, and zeros before and after.
const ROOM: usize = MOST_ORDER + 2 * BEFORE;

/// The Taylor coefficients of one step, and the memory that the recurrences need.
pub struct Expansion<M: Series<T>, T: Convolved> {
    scene: <M as Series<T>>::Scene,
    /// xₙ hⁿ
    coefficients: [FlatState<M, T>; MOST_ORDER + 1],
    sums: Lanes<M::Sums>,
    products: Lanes<M::Products>,
    /// 1/n
    inverse: [T; MOST_ORDER + 1],
    order: usize,
    unit: T,
    /// Σ xₙ hⁿ, 1 < n
    rest: FlatState<M, T>,
}

impl<M: Series<T>, T: Convolved> Expansion<M, T> {
    /// Room for coefficients up to `order`, which is 1 to [`MOST_ORDER`].
    pub fn new(parameters: &M::Parameters, order: usize) -> Self {
        let mut state = M::start(parameters).to_array();
        state.as_mut().fill(T::constant(0.0));
        let one = T::constant(1.0);
        let (sums, products) = M::zeros();
        Self {
            scene: <M as Series<T>>::scene(parameters),
            coefficients: [state; MOST_ORDER + 1],
            sums: Lanes::new(sums),
            products: Lanes::new(products),
            inverse: core::array::from_fn(|n| one / T::constant(n.max(1) as f64)),
            order: order.clamp(1, MOST_ORDER),
            unit: one,
            rest: state,
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
        self.unit = h;
        T::convolve(Recurrences {
            expansion: self,
            t,
            x,
            h,
        });
    }

    /// Forgets all series, of which sums would keep what is not finite.
    #[cold]
    pub(super) fn forget(&mut self) {
        self.sums = Lanes::new(self.sums.zeros);
        self.products = Lanes::new(self.products.zeros);
    }

    /// The unit of time.
    pub fn unit(&self) -> T {
        self.unit
    }

    /// What the motion adds to the state in `theta` units of time: Σ xₙ hⁿ θⁿ, 0 < n, even and odd orders apart.
    #[inline]
    pub fn change(&self, theta: T) -> FlatState<M, T> {
        let square = theta * theta;
        let mut even = self.zeros();
        let mut odd = even;
        let mut highest = self.order;
        if highest % 2 == 1 {
            odd = self.coefficients[highest];
            highest -= 1;
        }
        for pair in self.coefficients[1..=highest].rchunks_exact(2) {
            for i in 0..even.as_ref().len() {
                let (first, second) = (pair[0].as_ref()[i], pair[1].as_ref()[i]);
                even.as_mut()[i] = even.as_ref()[i] * square + second;
                odd.as_mut()[i] = odd.as_ref()[i] * square + first;
            }
        }
        for (odd, even) in odd.as_mut().iter_mut().zip(even.as_ref()) {
            *odd = theta * (*odd + theta * *even);
        }
        odd
    }

    fn zeros(&self) -> FlatState<M, T> {
        let mut zeros = self.coefficients[0];
        zeros.as_mut().fill(T::constant(0.0));
        zeros
    }

    /// What the step adds to the state: Σ xₙ hⁿ, 0 < n.
    pub fn increment(&self) -> FlatState<M, T> {
        let mut sum = self.coefficients[1];
        for (sum, rest) in sum.as_mut().iter_mut().zip(self.rest.as_ref()) {
            *sum = *sum + *rest;
        }
        sum
    }
}

/// Two series for each lane, aligned as vectors are: one that straddles two lines of the cache takes twice as long.
#[derive(Clone, Copy)]
#[repr(align(64))]
struct Lanes<L> {
    /// aₙ from order 2 on.
    left: [L; ROOM],
    /// bₙ from order 2 on, behind zeros.
    right: [L; ROOM],
    zeros: L,
}

/// What sums wait for, apart from what is kept in memory.
#[derive(Clone, Copy)]
struct Ends<L> {
    /// a₁ and b₁
    first: [L; 2],
    /// aₙ and bₙ of the last order.
    last: [L; 2],
}

impl<L: Copy> Lanes<L> {
    fn new(zeros: L) -> Self {
        Self {
            left: [zeros; ROOM],
            right: [zeros; ROOM],
            zeros,
        }
    }

    fn ends(&self) -> Ends<L> {
        Ends {
            first: [self.zeros; 2],
            last: [self.zeros; 2],
        }
    }

    /// Takes in aₙ and bₙ. They go to memory an order later, when they are vectors: what is stored number by number
    /// cannot be read as a whole for a while.
    #[inline(always)]
    fn push(&mut self, ends: &mut Ends<L>, n: usize, newest: [L; 2]) {
        if n > 2 {
            self.left[n - 1] = ends.last[0];
            self.right[n - 1 + BEFORE] = ends.last[1];
        }
        if n == 1 {
            ends.first = newest;
        }
        ends.last = newest;
    }

    /// Σ aⱼ bₙ₋ⱼ, 0 < j < n. What is newest comes last, so that the others need not wait for it.
    #[inline(always)]
    fn inner<T, A: Convolve<T>>(&self, ends: &Ends<L>, arithmetic: A, n: usize) -> L
    where
        L: Rows<T>,
    {
        let mut sums = arithmetic.inner(&self.left, &self.right, n, self.zeros);
        if n > 1 {
            sums = arithmetic.multiply_add(&ends.first[0], &ends.last[1], &sums);
        }
        if n > 2 {
            sums = arithmetic.multiply_add(&ends.last[0], &ends.first[1], &sums);
        }
        sums
    }
}

/// The recurrences of one step, for [`Convolved::convolve`].
struct Recurrences<'a, M: Series<T>, T: Convolved> {
    expansion: &'a mut Expansion<M, T>,
    t: T,
    x: &'a FlatState<M, T>,
    h: T,
}

impl<M: Series<T>, T: Convolved> Convolutions<T> for Recurrences<'_, M, T> {
    #[inline(always)]
    fn run<A: Convolve<T>>(self, arithmetic: A) {
        let Self { expansion, t, x, h } = self;
        let Expansion {
            scene,
            coefficients,
            sums,
            products,
            inverse,
            order: highest,
            rest,
            ..
        } = expansion;
        let zero = T::constant(0.0);
        let base = M::base(scene, t, x);
        let starts = M::starts(scene, &base);
        let mut rates = M::rates(scene, &base);
        let mut tail = *x;
        tail.as_mut().fill(zero);
        coefficients[0] = *x;
        let (mut sum_ends, mut product_ends) = (sums.ends(), products.ends());
        for n in 1..=*highest {
            let inner = sums.inner(&sum_ends, arithmetic, n);
            let whole = products.inner(&product_ends, arithmetic, n);

            let unit = h * inverse[n];
            let mut newest = rates;
            for x in newest.as_mut() {
                *x = unit * *x;
            }
            coefficients[n] = newest;
            if n > 1 {
                for (sum, x) in tail.as_mut().iter_mut().zip(newest.as_ref()) {
                    *sum = *sum + *x;
                }
            }
            if n == *highest {
                break;
            }

            let time = if n == 1 { h } else { zero };
            let order = [time, T::constant(n as f64), inverse[n]];
            let factors = M::factors(scene, &base, &newest, &order);
            let whole = arithmetic.multiply_add(&starts[0], &factors[1], &whole);
            let whole = arithmetic.multiply_add(&factors[0], &starts[1], &whole);
            let next = M::next(scene, &base, &newest, &order, &whole, &inner);
            rates = next.0;
            products.push(&mut product_ends, n, factors);
            sums.push(&mut sum_ends, n, next.1);
        }
        *rest = tail;
    }
}
