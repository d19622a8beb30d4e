//! `Series`: recurrences for the Taylor coefficients of the motion.

use super::allow;
use super::context::Body;
use super::context::Context;
use super::equations::lines;
use super::number::whole;
use crate::model::Model;
use crate::schedule::Expansion;
use proc_macro2::TokenStream;
use quote::quote;

/// The `Series` implementation of `Model`, with its caches.
pub(super) fn emit(model: &Model, expansion: &Expansion) -> TokenStream {
    let rows = whole(expansion.n_rows());
    let mut context = Context::of_series(model, expansion);
    let caches = [
        context.scene.declare("What depends on parameters only."),
        context.step.declare("What depends on the start of the step only."),
    ];
    let (scene_type, step_type) = (context.scene.ty(), context.step.ty());
    let functions = [
        scene_function(&mut context),
        step_function(&mut context),
        rates_function(&mut context),
        next_function(&mut context, expansion),
    ];
    let allow = allow();
    quote! {
        #allow
        mod series {
            #(#caches)*

            impl<T: ::residua::Scalar> ::residua::Series<T> for super::Model {
                type Scene = #scene_type;
                type Base = #step_type;
                type Lanes = [[T; 8]; #rows];

                fn lanes() -> [[T; 8]; #rows] {
                    [[T::constant(0.0); 8]; #rows]
                }

                #(#functions)*
            }
        }
    }
}

fn scene_function(context: &mut Context) -> TokenStream {
    let body = context.body("scene");
    let built = context.scene.build(body.roots.clone());
    let scene = context.scene.ty();
    let doc = format!(" Once per run: {}.", body.cost);
    let parameters = body.argument("parameters");
    let tokens = &body.tokens;
    quote! {
        #[doc = #doc]
        fn scene(#parameters: &super::Parameters<T>) -> #scene {
            #tokens
            #built
        }
    }
}

fn step_function(context: &mut Context) -> TokenStream {
    let body = context.body("step");
    let built = context.step.build(body.roots.clone());
    let (scene_type, step_type) = (context.scene.ty(), context.step.ty());
    let n = whole(context.model.n_states());
    let doc = format!(" Once per step: {}.", body.cost);
    let [scene, t, state] = ["scene", "t", "state"].map(|name| body.argument(name));
    let tokens = &body.tokens;
    quote! {
        #[doc = #doc]
        #[inline(always)]
        fn base(#scene: &#scene_type, #t: T, #state: &[T; #n]) -> #step_type {
            #tokens
            #built
        }
    }
}

fn rates_function(context: &mut Context) -> TokenStream {
    let body = context.body("rates");
    let (scene_type, step_type) = (context.scene.ty(), context.step.ty());
    let n = whole(context.model.n_states());
    let [scene, step] = ["scene", "step"].map(|name| body.argument(name));
    let Body { tokens, roots, .. } = &body;
    quote! {
        #[inline(always)]
        fn rates(#scene: &#scene_type, #step: &#step_type) -> [T; #n] {
            #tokens
            [#(#roots),*]
        }
    }
}

fn next_function(context: &mut Context, expansion: &Expansion) -> TokenStream {
    let body = context.body("next");
    let (scene_type, step_type) = (context.scene.ty(), context.step.ty());
    let n_states = context.model.n_states();
    let lines = lines(&context.model.flow);
    let doc = format!(
        " Order n{lines}: {} inner sums of n − 1 products, and {}.",
        expansion.n_lanes, body.cost
    );
    let [scene, step, newest, order, sums] =
        ["scene", "step", "newest", "order", "sums"].map(|name| body.argument(name));
    let (rates, sides) = body.roots.split_at(n_states);
    let (left, right) = sides.split_at(sides.len() / 2);
    let [left, right] = [left, right].map(|side| nested(side, Expansion::ROW));
    let (n, rows) = (whole(n_states), whole(expansion.n_rows()));
    let tokens = &body.tokens;
    quote! {
        #[doc = #doc]
        #[inline(always)]
        fn next(
            #scene: &#scene_type,
            #step: &#step_type,
            #newest: &[T; #n],
            #order: &[T; 3],
            #sums: &[[T; 8]; #rows],
        ) -> ([T; #n], [[T; 8]; #rows], [[T; 8]; #rows]) {
            #tokens
            ([#(#rates),*], #left, #right)
        }
    }
}

/// Rows of so many each.
fn nested(components: &[TokenStream], row: usize) -> TokenStream {
    let rows = components.chunks(row).map(|row| quote!([#(#row),*]));
    quote!([#(#rows),*])
}
