//! `Model`: defaults, start values and outputs.

use super::allow;
use super::context::Context;
use super::record::Record;
use super::requirements;
use crate::model::Model;
use crate::schedule::Program;
use crate::schedule::Schedule;
use proc_macro2::TokenStream;
use quote::quote;

/// The unit struct `Model`, its `Model` implementation and the defaults of `Parameters`.
pub(super) fn emit(model: &Model, program: &Program) -> TokenStream {
    let doc = doc(model);
    let defaults = defaults(model, &program.defaults);
    let start = start(model, &program.start);
    let outputs = outputs(model, &program.outputs);
    let meets = requirements::meets(model, program);
    let allow = allow();
    quote! {
        #(#[doc = #doc])*
        #[derive(Clone, Copy, Debug)]
        pub struct Model;

        #allow
        mod model {
            #defaults

            impl<T: ::residua::Scalar> ::residua::Model<T> for super::Model {
                type Parameters = super::Parameters<T>;
                type State = super::State<T>;
                type Outputs = super::Outputs<T>;
                const DESCRIPTION: &'static ::residua::Description = super::DESCRIPTION;

                #start

                #outputs

                #meets
            }
        }
    }
}

/// The model's own doc lines.
fn doc(model: &Model) -> Vec<String> {
    if model.doc.is_empty() {
        return vec![format!(" The model `{}`.", model.name)];
    }
    model
        .doc
        .iter()
        .map(|line| format!(" {}", line.trim()))
        .collect()
}

fn defaults(model: &Model, schedule: &Schedule) -> TokenStream {
    let body = Context::new(model, schedule).straight("defaults");
    let record = Record::parameters(model).build(&quote!(Self), |i| body.roots[i].clone());
    let tokens = &body.tokens;
    quote! {
        /// The values of the file.
        impl<T: ::residua::Scalar> ::core::default::Default for super::Parameters<T> {
            fn default() -> Self {
                #tokens
                #record
            }
        }
    }
}

fn start(model: &Model, schedule: &Schedule) -> TokenStream {
    let body = Context::new(model, schedule).straight("start");
    let record = Record::state(model).build(&quote!(super::State), |i| body.roots[i].clone());
    let parameters = body.argument("parameters");
    let tokens = &body.tokens;
    quote! {
        fn start(#parameters: &super::Parameters<T>) -> super::State<T> {
            #tokens
            #record
        }
    }
}

fn outputs(model: &Model, schedule: &Schedule) -> TokenStream {
    let body = Context::new(model, schedule).straight("outputs");
    let record = Record::outputs(model).build(&quote!(super::Outputs), |i| body.roots[i].clone());
    let [parameters, h, t, state] =
        ["parameters", "h", "t", "state"].map(|name| body.argument(name));
    let tokens = &body.tokens;
    quote! {
        fn outputs(
            #parameters: &super::Parameters<T>,
            #h: T,
            #t: T,
            #state: &super::State<T>,
        ) -> super::Outputs<T> {
            #tokens
            #record
        }
    }
}
