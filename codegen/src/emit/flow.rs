//! `Flow`: the continuous equations solved for the rates.

use super::allow;
use super::context::Context;
use super::equations::lines;
use super::number::whole;
use crate::model::Model;
use crate::schedule::Schedule;
use proc_macro2::TokenStream;
use quote::quote;

/// The `Flow` implementation of `Model`, with its cache.
pub(super) fn emit(model: &Model, schedule: &Schedule) -> TokenStream {
    let n = whole(model.n_states());
    let mut context = Context::new(model, schedule);
    let cache = context
        .scene
        .declare("What the flow needs of the parameters.");
    let scene_type = context.scene.ty();
    let scene = context.body("scene");
    let flow = context.body("flow");
    let built = context.scene.build(scene.roots.clone());
    let lines = lines(&model.flow);
    let doc = format!(" dx/dt, {n} components{lines}: {}.", flow.cost);
    let parameters = scene.argument("parameters");
    let [cached, t, state] = ["scene", "t", "state"].map(|name| flow.argument(name));
    let (scene_tokens, flow_tokens, rates) = (&scene.tokens, &flow.tokens, &flow.roots);
    let kinks = schedule.has_kinks("flow").then(|| {
        quote!(
            const FLOW_HAS_KINKS: bool = true;
        )
    });
    let allow = allow();
    quote! {
        #allow
        mod flow {
            #cache

            impl<T: ::residua::Scalar> ::residua::Flow<T> for super::Model {
                type FlowScene = #scene_type;
                #kinks

                fn flow_scene(#parameters: &super::Parameters<T>) -> #scene_type {
                    #scene_tokens
                    #built
                }

                #[doc = #doc]
                #[inline(always)]
                fn flow(#cached: &#scene_type, #t: T, #state: &[T; #n]) -> [T; #n] {
                    #flow_tokens
                    [#(#rates),*]
                }
            }
        }
    }
}
