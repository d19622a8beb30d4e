//! What a model may take to compile before its author is told.

use crate::model::Model;
use proc_macro2::Span;
use proc_macro2::TokenStream;
use quote::quote_spanned;

/// Operations of one model that take a minute or so, optimised and with all that the catalogue uses them for.
pub const BUDGET: usize = 10_000;

/// A warning, if the model is beyond the budget: what is deprecated is all that a macro can warn of.
pub(super) fn warning(model: &Model, operations: usize) -> TokenStream {
    if operations <= BUDGET {
        return TokenStream::new();
    }
    let note = format!(
        "`{}` has {operations} operations, over the budget of {BUDGET}, and takes long to compile: solve for one form only, \
         fix parameters in a scene that keeps no more than you need, or write allow(deprecated) on its module",
        model.name
    );
    let equations = model.residual.iter().chain(&model.flow);
    let first = equations.map(|equation| equation.range.start).next();
    let span = first.unwrap_or_else(Span::call_site);
    quote_spanned! {span=>
        const _: () = {
            #[deprecated(note = #note)]
            const BEYOND_BUDGET: () = ();
            BEYOND_BUDGET
        };
    }
}

#[cfg(test)]
mod tests {
    use super::BUDGET;
    use super::warning;
    use crate::analyse;

    #[test]
    fn a_model_beyond_the_budget_says_so() {
        let text = "state x; residual { Δx + h*x = 0; } start { x = 1; }";
        let analysis = analyse("decay", text.parse().unwrap());
        let model = analysis.unwrap_or_else(|_| panic!("a model")).model;
        assert!(warning(&model, BUDGET).is_empty());
        let shown = warning(&model, BUDGET + 1).to_string();
        assert!(shown.contains("`decay` has 10001 operations"), "{shown}");
    }
}
