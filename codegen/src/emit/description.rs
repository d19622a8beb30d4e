//! `DESCRIPTION` and `MODEL`: what the catalogue shows.

use super::number::float;
use super::number::whole;
use super::solver::name;
use crate::ast::Form;
use crate::ast::OutputKind;
use crate::finding::Difference;
use crate::finding::Finding;
use crate::model::Model;
use crate::model::Solved;
use crate::model::Variable;
use crate::scene::Receipt;
use crate::scene::Skipped;
use crate::schedule::Count;
use crate::schedule::Kernel;
use crate::schedule::Program;
use crate::schedule::Schedule;
use crate::schedule::Solver;
use proc_macro2::TokenStream;
use quote::quote;

/// `DESCRIPTION`
pub(super) fn emit(
    model: &Model,
    program: &Program,
    findings: &[Finding],
    receipt: Option<&Receipt>,
) -> TokenStream {
    let name = &model.name;
    let doc = model
        .doc
        .iter()
        .map(|line| line.trim())
        .collect::<Vec<_>>()
        .join("\n");
    let parameters = model.parameters.iter().map(|p| variable(&p.variable));
    let states = model.states.iter().map(|s| variable(&s.variable));
    let outputs = model.outputs.iter().map(|o| {
        let variable = variable(&o.variable);
        let invariant = o.kind == OutputKind::Invariant;
        quote!(::residua::description::Output { variable: #variable, invariant: #invariant })
    });
    let solvers = program.solvers.iter().map(|s| solver(model, s));
    let claims = findings.iter().map(claim);
    let requirements = super::requirements::described(model);
    let has_flow = program.flow.is_some();
    let series = program.series.as_ref();
    let no_series = match series {
        Some(Err(reason)) => quote!(::core::option::Option::Some(#reason)),
        Some(Ok(_)) | None => quote!(::core::option::Option::None),
    };
    let counts = std::iter::once(&program.outputs).chain(&program.flow);
    let counts = counts.flat_map(self::counts);
    let operations = whole(program.operations());
    let scene = match receipt {
        Some(receipt) => scene(receipt),
        None => quote!(::core::option::Option::None),
    };
    quote! {
        /// Names, shapes, units and texts.
        pub const DESCRIPTION: &::residua::Description = &::residua::Description {
            name: #name,
            doc: #doc,
            parameters: &[#(#parameters),*],
            states: &[#(#states),*],
            outputs: &[#(#outputs),*],
            solvers: &[#(#solvers),*],
            claims: &[#(#claims),*],
            requirements: &[#(#requirements),*],
            has_flow: #has_flow,
            no_series: #no_series,
            counts: &[#(#counts),*],
            operations: #operations,
            scene: #scene,
        };
    }
}

/// `MODEL`
pub(super) fn catalogued(program: &Program) -> TokenStream {
    let solvers = program.solvers.iter().map(|s| {
        let name = name(s.form);
        quote!(&::residua::erased::ErasedSolver::<#name>::NEW)
    });
    let flow = match program.flow {
        Some(_) => quote!(::core::option::Option::Some(
            &::residua::erased::ErasedFlow::<Model>::NEW
        )),
        None => quote!(::core::option::Option::None),
    };
    let series = match program.series {
        Some(Ok(_)) => quote!(::core::option::Option::Some(
            &::residua::erased::ErasedSeries::<Model>::NEW
        )),
        Some(Err(_)) | None => quote!(::core::option::Option::None),
    };
    quote! {
        /// The model behind one face, for programs that pick models at run time.
        pub static MODEL: ::residua::Catalogued = ::residua::Catalogued {
            description: DESCRIPTION,
            model: &::residua::erased::ErasedModel::<Model>::NEW,
            solvers: &[#(#solvers),*],
            flow: #flow,
            series: #series,
        };
    }
}

fn variable(variable: &Variable) -> TokenStream {
    let (name, ascii) = (&variable.name.display, &variable.name.ascii);
    let (rows, cols) = (whole(variable.shape.rows), whole(variable.shape.cols));
    let (unit, dimensionless) = (&variable.symbols, variable.unit.is_one());
    let doc = variable
        .doc
        .iter()
        .map(|line| line.trim())
        .collect::<Vec<_>>()
        .join("\n");
    quote! {
        ::residua::description::Variable {
            name: #name,
            ascii: #ascii,
            rows: #rows,
            cols: #cols,
            unit: #unit,
            dimensionless: #dimensionless,
            doc: #doc,
        }
    }
}

/// What a scene is and what it does without.
fn scene(receipt: &Receipt) -> TokenStream {
    let Receipt {
        model, keep, step, ..
    } = receipt;
    let (step, until) = (float(*step), float(receipt.until));
    let fixed = receipt.fixed.iter().map(|(name, values)| {
        let values = values.iter().copied().map(float);
        quote!(::residua::description::Fixed { name: #name, values: &[#(#values),*] })
    });
    let zeros = receipt.zeros.iter().map(|(component, reason)| {
        let component = whole(*component);
        quote!(::residua::description::Zero { component: #component, reason: #reason })
    });
    let skipped = receipt.skipped.iter().map(|skipped| {
        let (kind, line) = (skipped.kind.keyword(), whole(skipped.line));
        let Skipped { what, reason, .. } = skipped;
        quote! {
            ::residua::description::Skipped {
                kind: #kind,
                what: #what,
                reason: #reason,
                line: #line,
            }
        }
    });
    quote! {
        ::core::option::Option::Some(&::residua::description::Scene {
            model: #model,
            step: #step,
            until: #until,
            keep: &[#(#keep),*],
            fixed: &[#(#fixed),*],
            zeros: &[#(#zeros),*],
            skipped: &[#(#skipped),*],
        })
    }
}

fn solver(model: &Model, solver: &Solver) -> TokenStream {
    let form = solver.form.keyword();
    let unknowns = unknowns(model, solver.form, &solver.unknowns);
    let (pattern, counts) = (pattern(solver), counts(&solver.schedule));
    let core = match &solver.core {
        Some(core) => core_of(model, solver, core),
        None => quote!(::core::option::Option::None),
    };
    let equations = model.residual.iter().map(|e| {
        let (text, line, len) = (&e.text, whole(e.range.line()), whole(e.shape.len()));
        quote!(::residua::description::Equation { text: #text, line: #line, len: #len })
    });
    quote! {
        ::residua::description::Solver {
            form: #form,
            unknowns: &[#(#unknowns),*],
            equations: &[#(#equations),*],
            pattern: &[#(#pattern),*],
            counts: &[#(#counts),*],
            core: #core,
        }
    }
}

/// What is left of `solver` after elimination.
fn core_of(model: &Model, solver: &Solver, core: &Solver) -> TokenStream {
    let left = unknowns(model, solver.form, &core.unknowns);
    let others = solver.unknowns.iter().copied();
    let others: Vec<usize> = others.filter(|i| !core.unknowns.contains(i)).collect();
    let eliminated = unknowns(model, solver.form, &others);
    let mut lines = Vec::new();
    let mut offset = 0;
    for equation in &model.residual {
        let own = offset..offset + equation.shape.len();
        offset = own.end;
        let line = equation.range.line();
        if core.solved.iter().any(|row| own.contains(row)) && !lines.contains(&line) {
            lines.push(line);
        }
    }
    let lines = lines.into_iter().map(whole);
    let (pattern, counts) = (pattern(core), counts(&core.schedule));
    quote! {
        ::core::option::Option::Some(&::residua::description::Core {
            unknowns: &[#(#left),*],
            eliminated: &[#(#eliminated),*],
            lines: &[#(#lines),*],
            pattern: &[#(#pattern),*],
            counts: &[#(#counts),*],
        })
    }
}

/// The structural non-zeros of a Jacobian.
fn pattern(solver: &Solver) -> Vec<TokenStream> {
    let pair = |&(row, col): &(usize, usize)| {
        let (row, col) = (whole(row), whole(col));
        quote!((#row, #col))
    };
    solver.pattern.iter().map(pair).collect()
}

/// The operations of each kernel.
fn counts(schedule: &Schedule) -> Vec<TokenStream> {
    let count = |kernel: &Kernel| {
        let (name, count) = (kernel.name, count(schedule.count(kernel)));
        quote!((#name, #count))
    };
    schedule.kernels.iter().map(count).collect()
}

/// The blocks of some of the unknowns: components of one variable each.
pub(super) fn unknowns(model: &Model, form: Form, kept: &[usize]) -> Vec<TokenStream> {
    let mut blocks: Vec<(Solved, usize)> = Vec::new();
    for (i, (solved, _)) in model.unknown_components().enumerate() {
        match blocks.last_mut() {
            _ if !kept.contains(&i) => {}
            Some((last, len)) if *last == solved => *len += 1,
            Some(_) | None => blocks.push((solved, 1)),
        }
    }
    let blocks = blocks.into_iter();
    blocks
        .map(|(solved, len)| unknown(model, solved, form, len))
        .collect()
}

/// A block of unknowns: some components of a variable.
fn unknown(model: &Model, solved: Solved, form: Form, len: usize) -> TokenStream {
    let variable = model.solved_variable(solved);
    let shown = &variable.name.display;
    let name = match (solved, form) {
        (Solved::Own(_), _) => shown.clone(),
        (Solved::State(_), Form::Next) => format!("{shown}[k+1]"),
        (Solved::State(_), Form::Increment) => format!("Δ{shown}"),
    };
    let (measure, told) = match solved {
        Solved::Own(_) => (quote!(::core::option::Option::None), false),
        Solved::State(i) => {
            let start = whole(variable.offset);
            let end = whole(variable.offset + variable.shape.len());
            let told = len == variable.shape.len() && model.states[i].update.is_none();
            (quote!(::core::option::Option::Some(#start..#end)), told)
        }
    };
    let len = whole(len);
    quote! {
        ::residua::description::Unknown { name: #name, len: #len, measure: #measure, told: #told }
    }
}

fn count(count: Count) -> TokenStream {
    let (additions, multiplications) = (whole(count.additions), whole(count.multiplications));
    let (divisions, calls) = (whole(count.divisions), whole(count.calls));
    quote! {
        ::residua::description::Count {
            additions: #additions,
            multiplications: #multiplications,
            divisions: #divisions,
            calls: #calls,
        }
    }
}

fn claim(finding: &Finding) -> TokenStream {
    let (kind, label, line) = (finding.kind.keyword(), &finding.label, whole(finding.line));
    let of = match &finding.of {
        Some(label) => quote!(::core::option::Option::Some(#label)),
        None => quote!(::core::option::Option::None),
    };
    let differences = finding.differences.iter().map(|difference| {
        let Difference {
            entry,
            printed,
            derived,
            values,
            ..
        } = difference;
        let (row, col) = (whole(difference.row), whole(difference.col));
        let (first, second) = (float(values.0), float(values.1));
        quote! {
            ::residua::description::Difference {
                row: #row,
                col: #col,
                entry: #entry,
                printed: #printed,
                derived: #derived,
                values: (#first, #second),
            }
        }
    });
    quote! {
        ::residua::description::Claim {
            kind: #kind,
            label: #label,
            of: #of,
            line: #line,
            differences: &[#(#differences),*],
        }
    }
}
