//! `Series`: recurrences for the Taylor coefficients of the motion.

use super::allow;
use super::context::Body;
use super::context::Context;
use super::equations::lines;
use super::fillers::scene_function;
use super::fillers::step_function;
use super::number::whole;
use crate::model::Model;
use crate::schedule::Expansion;
use proc_macro2::TokenStream;
use quote::quote;

/// The `Series` implementation of `Model`, with its caches.
pub(super) fn emit(model: &Model, expansion: &Expansion) -> TokenStream {
    let rows = [expansion.n_sums, expansion.n_products].map(Expansion::rows);
    let [sum_rows, product_rows] = rows.map(whole);
    let mut context = Context::of_series(model, expansion);
    let caches = [
        context.scene.declare("What depends on parameters only."),
        context
            .step
            .declare("What depends on the start of the step only."),
    ];
    let (scene_type, step_type) = (context.scene.ty(), context.step.ty());
    let functions = [
        scene_function(&mut context, false),
        step_function(&mut context, "base"),
        rates_function(&mut context),
        starts_function(&mut context),
        factors_function(&mut context),
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
                type Sums = [[T; 4]; #sum_rows];
                type Products = [[T; 4]; #product_rows];

                fn zeros() -> (Self::Sums, Self::Products) {
                    let row = [T::constant(0.0); 4];
                    ([row; #sum_rows], [row; #product_rows])
                }

                #(#functions)*
            }
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

fn starts_function(context: &mut Context) -> TokenStream {
    let body = context.body("starts");
    let (scene_type, step_type) = (context.scene.ty(), context.step.ty());
    let [scene, step] = ["scene", "step"].map(|name| body.argument(name));
    let tokens = &body.tokens;
    let [left, right] = sides(&body.roots);
    quote! {
        #[inline(always)]
        fn starts(#scene: &#scene_type, #step: &#step_type) -> [Self::Products; 2] {
            #tokens
            [#left, #right]
        }
    }
}

fn factors_function(context: &mut Context) -> TokenStream {
    let body = context.body("factors");
    let (scene_type, step_type) = (context.scene.ty(), context.step.ty());
    let n = whole(context.model.n_states());
    let doc = format!(" Order n of what is multiplied: {}.", body.cost);
    let [scene, step, newest, order] =
        ["scene", "step", "newest", "order"].map(|name| body.argument(name));
    let tokens = &body.tokens;
    let [left, right] = sides(&body.roots);
    quote! {
        #[doc = #doc]
        #[inline(always)]
        fn factors(
            #scene: &#scene_type,
            #step: &#step_type,
            #newest: &[T; #n],
            #order: &[T; 3],
        ) -> [Self::Products; 2] {
            #tokens
            [#left, #right]
        }
    }
}

fn next_function(context: &mut Context, expansion: &Expansion) -> TokenStream {
    let body = context.body("next");
    let (scene_type, step_type) = (context.scene.ty(), context.step.ty());
    let n_states = context.model.n_states();
    let lines = lines(&context.model.flow);
    let doc = format!(
        " Order n{lines}: {} sums of n + 1 products, {} sums of n − 1 products, and {}.",
        expansion.n_products, expansion.n_sums, body.cost
    );
    let arguments = ["scene", "step", "newest", "order", "products", "sums"];
    let [scene, step, newest, order, products, sums] = arguments.map(|name| body.argument(name));
    let (rates, lanes) = body.roots.split_at(n_states);
    let [left, right] = sides(lanes);
    let n = whole(n_states);
    let tokens = &body.tokens;
    quote! {
        #[doc = #doc]
        #[inline(always)]
        fn next(
            #scene: &#scene_type,
            #step: &#step_type,
            #newest: &[T; #n],
            #order: &[T; 3],
            #products: &Self::Products,
            #sums: &Self::Sums,
        ) -> ([T; #n], [Self::Sums; 2]) {
            #tokens
            ([#(#rates),*], [#left, #right])
        }
    }
}

/// Both halves of `lanes` in rows.
fn sides(lanes: &[TokenStream]) -> [TokenStream; 2] {
    let (left, right) = lanes.split_at(lanes.len() / 2);
    [left, right].map(|side| {
        let rows = side.chunks(Expansion::ROW).map(|row| quote!([#(#row),*]));
        quote!([#(#rows),*])
    })
}
