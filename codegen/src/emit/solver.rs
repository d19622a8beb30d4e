//! `Next` and `Increment`: residual, Jacobian and what follows from the solution.

use super::allow;
use super::context::Context;
use super::description::unknowns;
use super::equations::lines;
use super::equations::rows;
use super::expression::Expression;
use super::fillers::scene_function;
use super::fillers::step_function;
use super::number::whole;
use super::scope::identifier;
use crate::ast::Form;
use crate::model::Model;
use crate::schedule::Solver;
use proc_macro2::Ident;
use proc_macro2::Literal;
use proc_macro2::TokenStream;
use quote::quote;

/// The unit struct of a form and its `System` implementation, with its caches; and those of its core.
pub(super) fn emit(model: &Model, solver: &Solver, index: usize) -> TokenStream {
    let form = solver.form;
    let core = solver.core.as_deref();
    let full = Role {
        name: name(form),
        module: identifier(form.keyword()),
        doc: doc(form).to_owned(),
        equations: lines(&model.residual),
        listed: rows(&model.residual),
        own: match core {
            None => quote!(
                type Core = Self;
            ),
            Some(_) => {
                let core = core_name(form);
                quote! {
                    type Core = super::#core;
                    const HAS_CORE: bool = true;
                }
            }
        },
    };
    let items = system(model, solver, index, &full, TokenStream::new());
    let core = core.map(|core| self::core(model, core, index, solver.unknowns.len()));
    quote!(#items #core)
}

/// What tells a solver from its core.
struct Role {
    name: Ident,
    module: Ident,
    doc: String,
    /// Where the equations stand, behind a comma.
    equations: String,
    /// The equations, as doc lines.
    listed: Vec<String>,
    /// Associated items of its own.
    own: TokenStream,
}

/// The system that is left after elimination.
fn core(model: &Model, solver: &Solver, index: usize, of: usize) -> TokenStream {
    let form = solver.form;
    let (name, full, n) = (core_name(form), self::name(form), solver.unknowns.len());
    let blocks = unknowns(model, form, &solver.unknowns);
    let role = Role {
        name,
        module: identifier(&format!("{}_core", form.keyword())),
        doc: format!(
            " What [`{full}`] iterates on: {n} of its {of} unknowns. The others enter linearly and are eliminated."
        ),
        equations: " after elimination".to_owned(),
        listed: Vec::new(),
        own: quote! {
            type Core = Self;
            const UNKNOWNS: &'static [::residua::description::Unknown] = &[#(#blocks),*];
        },
    };
    let mut context = Context::of_solver(model, solver);
    let growth = growth_function(&mut context, &whole(n));
    system(model, solver, index, &role, growth)
}

fn system(
    model: &Model,
    solver: &Solver,
    index: usize,
    role: &Role,
    more: TokenStream,
) -> TokenStream {
    let n = &whole(solver.unknowns.len());
    let mut context = Context::of_solver(model, solver);
    let caches = [
        context
            .scene
            .declare("What a run needs of the parameters and h."),
        context
            .step
            .declare("What a step needs of the known state and t."),
    ];
    let (scene, step) = (context.scene.ty(), context.step.ty());
    let components = context.scene.components();
    let functions = [
        scene_function(&mut context, true),
        step_function(&mut context, "step"),
        guess_function(&mut context, n),
        residual_function(&mut context, role, n),
        jacobian_function(&mut context, solver, role, n),
        correction_function(&mut context, n),
        state_function(&mut context, n, "next", "The state after the step"),
        change_function(&mut context, n),
        rounding_function(&context, n),
        more,
    ];
    let kinks = solver.schedule.has_kinks("residual").then(|| {
        quote!(
            const HAS_KINKS: bool = true;
        )
    });
    let index = whole(index);
    let Role {
        name,
        module,
        doc,
        own,
        ..
    } = role;
    let allow = allow();
    quote! {
        #[doc = #doc]
        #[derive(Clone, Copy, Debug)]
        pub struct #name;

        #allow
        mod #module {
            #(#caches)*
            #components

            impl<T: ::residua::Scalar> ::residua::System<T> for super::#name {
                type Model = super::Model;
                type Unknowns = [T; #n];
                type Jacobian = [[T; #n]; #n];
                type Scene = #scene;
                type Step = #step;
                #own
                const SOLVER: usize = #index;
                #kinks

                fn zeros() -> ([T; #n], [[T; #n]; #n]) {
                    let zero = T::constant(0.0);
                    ([zero; #n], [[zero; #n]; #n])
                }

                #(#functions)*
            }
        }
    }
}

/// The unit struct of the core of a form.
fn core_name(form: Form) -> Ident {
    identifier(&format!("{}Core", name(form)))
}

/// The unit struct of a form.
pub(super) fn name(form: Form) -> Ident {
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

fn guess_function(context: &mut Context, n: &Literal) -> TokenStream {
    let body = context.body("guess");
    let (scene_type, step_type) = (context.scene.ty(), context.step.ty());
    let [scene, step] = ["scene", "step"].map(|name| body.argument(name));
    let (tokens, roots) = (&body.tokens, &body.roots);
    quote! {
        #[inline(always)]
        fn guess(#scene: &#scene_type, #step: &#step_type) -> [T; #n] {
            #tokens
            [#(#roots),*]
        }
    }
}

fn residual_function(context: &mut Context, role: &Role, n: &Literal) -> TokenStream {
    let assign = |row: usize, value: Expression| {
        let (row, value) = (whole(row), value.tokens);
        quote!(residual[#row] = #value;)
    };
    let body = context.body_with("residual", assign);
    let (scene_type, step_type) = (context.scene.ty(), context.step.ty());
    let lines = &role.equations;
    let mut doc = vec![format!(" r(x), {n} equations{lines}: {}.", body.cost)];
    doc.extend(role.listed.iter().cloned());
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

fn jacobian_function(
    context: &mut Context,
    solver: &Solver,
    role: &Role,
    n: &Literal,
) -> TokenStream {
    // Row by row the residual and the entries of its row, as `stage` has ordered them.
    let mut places = Vec::new();
    for row in 0..solver.unknowns.len() {
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
        role.equations, body.cost,
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

fn correction_function(context: &mut Context, n: &Literal) -> TokenStream {
    if !context.has("correction") {
        return TokenStream::new();
    }
    let body = context.body("correction");
    let (scene_type, step_type) = (context.scene.ty(), context.step.ty());
    let doc = format!(
        " J(x)⁻¹ r(x) in closed form, and the growth of rounding in it: {}.",
        body.cost
    );
    let [scene, step, unknowns] = ["scene", "step", "unknowns"].map(|name| body.argument(name));
    let tokens = &body.tokens;
    let Some((growth, x)) = body.roots.split_last() else {
        return TokenStream::new();
    };
    quote! {
        const HAS_CORRECTION: bool = true;

        #[doc = #doc]
        #[inline(always)]
        fn correction(
            #scene: &#scene_type,
            #step: &#step_type,
            #unknowns: &[T; #n],
        ) -> ([T; #n], T) {
            #tokens
            ([#(#x),*], #growth)
        }
    }
}

fn change_function(context: &mut Context, n: &Literal) -> TokenStream {
    if !context.has("change") {
        return TokenStream::new();
    }
    let function = state_function(context, n, "change", "What the step adds to the state");
    quote! {
        const HAS_CHANGE: bool = true;
        #function
    }
}

/// The same straight lines, in numbers that know how far rounding may have taken them.
fn rounding_function(context: &Context, n: &Literal) -> TokenStream {
    let n_states = whole(context.model.n_states());
    quote! {
        fn rounding(
            parameters: &super::Parameters<T>,
            h: T,
            t: T,
            state: &[T; #n_states],
            unknowns: &[T; #n],
        ) -> ([T; #n], [T; #n_states])
        where
            T: ::residua::Real,
        {
            ::residua::rounding::<Self, T>(parameters, h, t, state, unknowns)
        }
    }
}

/// A function from the unknowns to components of the state.
fn state_function(context: &mut Context, n: &Literal, name: &str, what: &str) -> TokenStream {
    let body = context.body(name);
    let (scene_type, step_type) = (context.scene.ty(), context.step.ty());
    let n_states = whole(context.model.n_states());
    let doc = format!(" {what}: {}.", body.cost);
    let [scene, step, unknowns] = ["scene", "step", "unknowns"].map(|name| body.argument(name));
    let (tokens, roots, name) = (&body.tokens, &body.roots, identifier(name));
    quote! {
        #[doc = #doc]
        #[inline(always)]
        fn #name(#scene: &#scene_type, #step: &#step_type, #unknowns: &[T; #n]) -> [T; #n_states] {
            #tokens
            [#(#roots),*]
        }
    }
}

fn growth_function(context: &mut Context, n: &Literal) -> TokenStream {
    let body = context.body("growth");
    let (scene_type, step_type) = (context.scene.ty(), context.step.ty());
    let doc = format!(" Σ|terms|/|Σ terms| over the divisors: {}.", body.cost);
    let [scene, step, unknowns] = ["scene", "step", "unknowns"].map(|name| body.argument(name));
    let (tokens, roots) = (&body.tokens, &body.roots);
    quote! {
        #[doc = #doc]
        #[inline(always)]
        fn growth(#scene: &#scene_type, #step: &#step_type, #unknowns: &[T; #n]) -> T {
            #tokens
            #(#roots)*
        }
    }
}
