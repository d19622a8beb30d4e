//! What the data of a run must be like: `Model::meets`, and its texts in the description.

use super::context::Context;
use super::number::whole;
use crate::ast::Relation;
use crate::model::Model;
use crate::model::Requirement;
use crate::schedule::Program;
use proc_macro2::TokenStream;
use quote::quote;

/// `Model::meets`; nothing where there is no requirement.
pub(super) fn meets(model: &Model, program: &Program) -> TokenStream {
    if model.requirements.is_empty() {
        return TokenStream::new();
    }
    let requirements = model.requirements.iter().zip(&program.requirements);
    let names = ["parameters", "h", "state"];
    let (mut arms, mut are_used) = (Vec::new(), [false; 3]);
    for (i, (requirement, schedule)) in requirements.enumerate() {
        let body = Context::new(model, schedule).straight("requirement");
        for (is_used, name) in are_used.iter_mut().zip(names) {
            *is_used |= body.argument(name) == name;
        }
        let holds = holds(requirement, &body.roots);
        let (i, tokens) = (whole(i), &body.tokens);
        arms.push(quote!(#i => { #tokens #holds }));
    }
    let mut arguments = names.iter().zip(are_used).map(|(name, is_used)| {
        let underscore = if is_used { "" } else { "_" };
        super::scope::identifier(&format!("{underscore}{name}"))
    });
    let [parameters, h, state] = std::array::from_fn(|_| arguments.next());
    quote! {
        fn meets(
            requirement: usize,
            #parameters: &super::Parameters<T>,
            #h: T,
            #state: &super::State<T>,
        ) -> bool
        where
            T: ::residua::Real,
        {
            match requirement {
                #(#arms)*
                _ => true,
            }
        }
    }
}

/// Whether the sides, components of the left one first, compare as required.
fn holds(requirement: &Requirement, sides: &[TokenStream]) -> TokenStream {
    let (rows, cols) = (requirement.shape.rows, requirement.shape.cols);
    let (left, right) = sides.split_at(rows * cols);
    let relation = match requirement.relation {
        Relation::Less => quote!(Less),
        Relation::LessOrEqual => quote!(LessOrEqual),
        Relation::Greater => quote!(Greater),
        Relation::GreaterOrEqual => quote!(GreaterOrEqual),
    };
    let relation = quote!(::residua::Relation::#relation);
    if rows == cols && rows > 1 {
        let [left, right] = [left, right].map(|side| {
            let rows = side.chunks(cols).map(|row| quote!([#(#row),*]));
            quote!([#(#rows),*])
        });
        quote!(#relation.holds_for_matrices(&#left, &#right))
    } else {
        quote!(#relation.holds_for_all(&[#(#left),*], &[#(#right),*]))
    }
}

/// The texts.
pub(super) fn described(model: &Model) -> impl Iterator<Item = TokenStream> {
    model.requirements.iter().map(|requirement| {
        let Requirement {
            text, otherwise, ..
        } = requirement;
        let line = whole(requirement.range.line());
        quote! {
            ::residua::description::Requirement { text: #text, otherwise: #otherwise, line: #line }
        }
    })
}
