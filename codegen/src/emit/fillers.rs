//! The functions that fill the caches of a solver or of a series.

use super::context::Context;
use super::number::whole;
use super::scope::identifier;
use proc_macro2::TokenStream;
use quote::quote;

/// `scene`: what is computed once per run, of the parameters and, where equations have one, of the step.
pub(super) fn scene_function(context: &mut Context, has_step: bool) -> TokenStream {
    let body = context.body("scene");
    let built = context.scene.build(body.roots.clone());
    let scene = context.scene.ty();
    let doc = format!(" Once per run: {}.", body.cost);
    let [parameters, h] = ["parameters", "h"].map(|name| body.argument(name));
    let h = has_step.then(|| quote!(#h: T));
    let tokens = &body.tokens;
    quote! {
        #[doc = #doc]
        fn scene(#parameters: &super::Parameters<T>, #h) -> #scene {
            #tokens
            #built
        }
    }
}

/// What is computed once per step, as the function `name`.
pub(super) fn step_function(context: &mut Context, name: &str) -> TokenStream {
    let body = context.body("step");
    let built = context.step.build(body.roots.clone());
    let (scene_type, step_type) = (context.scene.ty(), context.step.ty());
    let n = whole(context.model.n_states());
    let doc = format!(" Once per step: {}.", body.cost);
    let [scene, t, state] = ["scene", "t", "state"].map(|name| body.argument(name));
    let (tokens, name) = (&body.tokens, identifier(name));
    quote! {
        #[doc = #doc]
        #[inline(always)]
        fn #name(#scene: &#scene_type, #t: T, #state: &[T; #n]) -> #step_type {
            #tokens
            #built
        }
    }
}
