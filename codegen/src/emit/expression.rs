//! Tokens of an expression, with what is needed to put them into a larger one.

use crate::dag::Elementary;
use proc_macro2::Ident;
use proc_macro2::Literal;
use proc_macro2::TokenStream;
use quote::ToTokens;
use quote::format_ident;
use quote::quote;

/// How tightly the outermost operator binds.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) enum Binding {
    /// `a + b`, `-a`
    Sum,
    /// `a * b / c`
    Product,
    /// A name or a call.
    Atom,
}

/// An expression.
#[derive(Clone, Debug)]
pub(super) struct Expression {
    pub(super) tokens: TokenStream,
    binding: Binding,
    /// Characters, roughly.
    pub(super) length: usize,
}

impl Expression {
    /// A variable.
    pub(super) fn name(name: &Ident) -> Self {
        Self {
            length: name.to_string().len(),
            tokens: name.to_token_stream(),
            binding: Binding::Atom,
        }
    }

    /// In parentheses unless it binds at least as tightly as `binding`.
    fn within(self, binding: Binding) -> Self {
        if self.binding >= binding {
            return self;
        }
        let tokens = self.tokens;
        Self {
            tokens: quote!((#tokens)),
            binding: Binding::Atom,
            length: self.length + 2,
        }
    }

    /// Σ ± terms, left to right; `true` is minus.
    pub(super) fn sum(terms: Vec<(bool, Expression)>) -> Self {
        let mut tokens = TokenStream::new();
        let mut length = 0;
        for (i, (is_negative, term)) in terms.into_iter().enumerate() {
            let is_leading = i == 0 && !is_negative;
            let term = if is_leading {
                term
            } else {
                term.within(Binding::Product)
            };
            let value = term.tokens;
            length += term.length + 3;
            tokens.extend(match (is_negative, is_leading) {
                (true, _) => quote!(- #value),
                (false, true) => value,
                (false, false) => quote!(+ #value),
            });
        }
        Self {
            tokens,
            binding: Binding::Sum,
            length,
        }
    }

    /// Π factors / Π divisors, left to right.
    pub(super) fn product(factors: Vec<Expression>, divisors: Vec<Expression>) -> Self {
        let mut tokens = TokenStream::new();
        let mut length = 0;
        for (i, factor) in factors.into_iter().enumerate() {
            let binding = if i == 0 {
                Binding::Product
            } else {
                Binding::Atom
            };
            let factor = factor.within(binding);
            let value = factor.tokens;
            length += factor.length + 3;
            tokens.extend(if i == 0 { value } else { quote!(* #value) });
        }
        for divisor in divisors {
            let divisor = divisor.within(Binding::Atom);
            let value = divisor.tokens;
            length += divisor.length + 3;
            tokens.extend(quote!(/ #value));
        }
        Self {
            tokens,
            binding: Binding::Product,
            length,
        }
    }

    /// c · value. A power of two is exact, so it goes in front without parentheses: every other
    /// factor would have to round as it does where `value` has a name.
    pub(super) fn scaled(factor: Expression, is_power_of_two: bool, value: Expression) -> Self {
        if value.binding != Binding::Product || !is_power_of_two {
            return Self::product(vec![factor, value], Vec::new());
        }
        let (front, tokens) = (factor.tokens, value.tokens);
        Self {
            tokens: quote!(#front * #tokens),
            binding: Binding::Product,
            length: factor.length + value.length + 3,
        }
    }

    /// f(x) or f(x, y); `arguments` is not empty.
    pub(super) fn call(function: Elementary, mut arguments: Vec<Expression>) -> Self {
        let mut rest = arguments.split_off(1);
        if let Elementary::Stumpff(n) = function {
            rest.push(Self {
                tokens: Literal::u32_unsuffixed(n).to_token_stream(),
                binding: Binding::Atom,
                length: 1,
            });
        }
        Self::method(arguments.remove(0), method(function), rest)
    }

    /// x.name(…)
    pub(super) fn method(receiver: Expression, name: &str, arguments: Vec<Expression>) -> Self {
        let receiver = receiver.within(Binding::Atom);
        let others: usize = arguments.iter().map(|a| a.length + 2).sum();
        let length = receiver.length + name.len() + 3 + others;
        let method = format_ident!("{name}");
        let receiver = receiver.tokens;
        let arguments = arguments.into_iter().map(|a| a.tokens);
        Self {
            tokens: quote!(#receiver.#method(#(#arguments),*)),
            binding: Binding::Atom,
            length,
        }
    }
}

/// The method of `residua::Scalar`.
pub(super) fn method(function: Elementary) -> &'static str {
    match function {
        Elementary::Sin => "sin",
        Elementary::Cos => "cos",
        Elementary::Tan => "tan",
        Elementary::Asin => "asin",
        Elementary::Acos => "acos",
        Elementary::Atan => "atan",
        Elementary::Atan2 => "atan2",
        Elementary::Sinh => "sinh",
        Elementary::Cosh => "cosh",
        Elementary::Tanh => "tanh",
        Elementary::Exp => "exp",
        Elementary::Log => "ln",
        Elementary::Sqrt => "sqrt",
        Elementary::Abs => "abs",
        Elementary::Sign => "sign",
        Elementary::Positive => "positive",
        Elementary::Power => "powf",
        Elementary::Stumpff(_) => "stumpff",
    }
}
