//! `Next` and `Increment`: residual, Jacobian and what follows from the solution.

use super::allow;
use super::context::Context;
use super::equations::lines;
use super::equations::rows;
use super::expression::Expression;
use super::number::whole;
use super::scope::identifier;
use crate::ast::Form;
use crate::model::Model;
use crate::schedule::Solver;
use proc_macro2::Literal;
use proc_macro2::TokenStream;
use quote::quote;

/// The unit struct of a form and its `System` implementation, with its caches.
pub(super) fn emit(model: &Model, solver: &Solver, index: usize) -> TokenStream {
    let n = &whole(model.n_unknowns());
    let mut context = Context::new(model, Some(solver.form), &solver.schedule);
    let caches = [
        context
            .scene
            .declare("What a run needs of the parameters and h."),
        context
            .step
            .declare("What a step needs of the known state and t."),
    ];
    let (scene, step) = (context.scene.ty(), context.step.ty());
    let functions = [
        scene_function(&mut context),
        step_function(&mut context),
        guess_function(&mut context, n),
        residual_function(&mut context, n),
        jacobian_function(&mut context, solver, n),
        next_function(&mut context, n),
    ];
    let (name, index) = (name(solver.form), whole(index));
    let (doc, module) = (doc(solver.form), identifier(solver.form.keyword()));
    let allow = allow();
    quote! {
        #[doc = #doc]
        #[derive(Clone, Copy, Debug)]
        pub struct #name;

        #allow
        mod #module {
            #(#caches)*

            impl<T: ::residua::Scalar> ::residua::System<T> for super::#name {
                type Model = super::Model;
                type Unknowns = [T; #n];
                type Jacobian = [[T; #n]; #n];
                type Scene = #scene;
                type Step = #step;
                const SOLVER: usize = #index;

                fn zeros() -> ([T; #n], [[T; #n]; #n]) {
                    let zero = T::constant(0.0);
                    ([zero; #n], [[zero; #n]; #n])
                }

                #(#functions)*
            }
        }
    }
}

/// The unit struct of a form.
pub(super) fn name(form: Form) -> proc_macro2::Ident {
    match form {
        Form::Next => identifier("Next"),
        Form::Increment => identifier("Increment"),
    }
}

fn doc(form: Form) -> &'static str {
    match form {
        Form::Next => {
            " The solver whose unknowns are the next states, and those the model declares."
        }
        Form::Increment => {
            " The solver whose unknowns are the increments, and those the model declares."
        }
    }
}

fn scene_function(context: &mut Context) -> TokenStream {
    let body = context.body("scene");
    let built = context.scene.build(body.roots.clone());
    let scene = context.scene.ty();
    let doc = format!(" Once per run: {}.", body.cost);
    let [parameters, h] = ["parameters", "h"].map(|name| body.argument(name));
    let tokens = &body.tokens;
    quote! {
        #[doc = #doc]
        fn scene(#parameters: &super::Parameters<T>, #h: T) -> #scene {
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
        fn step(#scene: &#scene_type, #t: T, #state: &[T; #n]) -> #step_type {
            #tokens
            #built
        }
    }
}

fn guess_function(context: &mut Context, n: &Literal) -> TokenStream {
    let body = context.body("guess");
    let (scene_type, step_type) = (context.scene.ty(), context.step.ty());
    let [scene, step] = ["scene", "step"].map(|name| body.argument(name));
    let (tokens, roots) = (&body.tokens, &body.roots);
    quote! {
        fn guess(#scene: &#scene_type, #step: &#step_type) -> [T; #n] {
            #tokens
            [#(#roots),*]
        }
    }
}

fn residual_function(context: &mut Context, n: &Literal) -> TokenStream {
    let assign = |row: usize, value: Expression| {
        let (row, value) = (whole(row), value.tokens);
        quote!(residual[#row] = #value;)
    };
    let body = context.body_with("residual", assign);
    let (scene_type, step_type) = (context.scene.ty(), context.step.ty());
    let lines = lines(&context.model.residual);
    let mut doc = vec![format!(" r(x), {n} equations{lines}: {}.", body.cost)];
    doc.extend(rows(&context.model.residual));
    let [scene, step, unknowns] = ["scene", "step", "unknowns"].map(|name| body.argument(name));
    let tokens = &body.tokens;
    quote! {
        #(#[doc = #doc])*
        fn residual(
            #scene: &#scene_type,
            #step: &#step_type,
            #unknowns: &[T; #n],
            residual: &mut [T; #n],
        ) {
            #tokens
        }
    }
}

fn jacobian_function(context: &mut Context, solver: &Solver, n: &Literal) -> TokenStream {
    // Row by row the residual and the entries of its row, as `stage` has ordered them.
    let mut places = Vec::new();
    for row in 0..context.model.n_unknowns() {
        places.push((row, None));
        let entries = solver.pattern.iter().filter(|(r, _)| *r == row);
        places.extend(entries.map(|(r, col)| (*r, Some(*col))));
    }
    let assign = |i: usize, value: Expression| {
        let value = value.tokens;
        match places[i] {
            (row, None) => {
                let row = whole(row);
                quote!(residual[#row] = #value;)
            }
            (row, Some(col)) => {
                let (row, col) = (whole(row), whole(col));
                quote!(jacobian[#row][#col] = #value;)
            }
        }
    };
    let body = context.body_with("residual_and_jacobian", assign);
    let (scene_type, step_type) = (context.scene.ty(), context.step.ty());
    let entries = solver.pattern.len();
    let doc = format!(
        " r(x) and the {entries} structural non-zeros of its Jacobian{}: {}.",
        lines(&context.model.residual),
        body.cost,
    );
    let [scene, step, unknowns] = ["scene", "step", "unknowns"].map(|name| body.argument(name));
    let tokens = &body.tokens;
    quote! {
        #[doc = #doc]
        fn residual_and_jacobian(
            #scene: &#scene_type,
            #step: &#step_type,
            #unknowns: &[T; #n],
            residual: &mut [T; #n],
            jacobian: &mut [[T; #n]; #n],
        ) {
            #tokens
        }
    }
}

fn next_function(context: &mut Context, n: &Literal) -> TokenStream {
    let body = context.body("next");
    let (scene_type, step_type) = (context.scene.ty(), context.step.ty());
    let n_states = whole(context.model.n_states());
    let doc = format!(" The state after the step: {}.", body.cost);
    let [scene, step, unknowns] = ["scene", "step", "unknowns"].map(|name| body.argument(name));
    let (tokens, roots) = (&body.tokens, &body.roots);
    quote! {
        #[doc = #doc]
        fn next(#scene: &#scene_type, #step: &#step_type, #unknowns: &[T; #n]) -> [T; #n_states] {
            #tokens
            [#(#roots),*]
        }
    }
}
