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
use crate::schedule::Count;
use crate::schedule::Program;
use crate::schedule::Solver;
use proc_macro2::TokenStream;
use quote::quote;

/// `DESCRIPTION`
pub(super) fn emit(model: &Model, program: &Program, findings: &[Finding]) -> TokenStream {
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
    let has_flow = program.flow.is_some();
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
            has_flow: #has_flow,
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
    quote! {
        /// The model behind one face, for programs that pick models at run time.
        pub static MODEL: ::residua::Catalogued = ::residua::Catalogued {
            description: DESCRIPTION,
            model: &::residua::erased::ErasedModel::<Model>::NEW,
            solvers: &[#(#solvers),*],
            flow: #flow,
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

fn solver(model: &Model, solver: &Solver) -> TokenStream {
    let form = solver.form.keyword();
    let unknowns = model
        .solved
        .iter()
        .map(|&s| unknown(model, s, solver.form, model.solved_variable(s).shape.len()));
    let equations = model.residual.iter().map(|e| {
        let (text, line, len) = (&e.text, whole(e.range.line()), whole(e.shape.len()));
        quote!(::residua::description::Equation { text: #text, line: #line, len: #len })
    });
    let pattern = solver.pattern.iter().map(|(row, col)| {
        let (row, col) = (whole(*row), whole(*col));
        quote!((#row, #col))
    });
    let counts = solver.schedule.kernels.iter().map(|kernel| {
        let (name, count) = (kernel.name, count(solver.schedule.count(kernel)));
        quote!((#name, #count))
    });
    quote! {
        ::residua::description::Solver {
            form: #form,
            unknowns: &[#(#unknowns),*],
            equations: &[#(#equations),*],
            pattern: &[#(#pattern),*],
            counts: &[#(#counts),*],
        }
    }
}

/// A block of unknowns: some components of a variable.
pub(super) fn unknown(model: &Model, solved: Solved, form: Form, len: usize) -> TokenStream {
    let variable = model.solved_variable(solved);
    let (shown, len) = (&variable.name.display, whole(len));
    let name = match (solved, form) {
        (Solved::Own(_), _) => shown.clone(),
        (Solved::State(_), Form::Next) => format!("{shown}[k+1]"),
        (Solved::State(_), Form::Increment) => format!("Δ{shown}"),
    };
    let measure = match solved {
        Solved::Own(_) => quote!(::core::option::Option::None),
        Solved::State(_) => {
            let start = whole(variable.offset);
            let end = whole(variable.offset + variable.shape.len());
            quote!(::core::option::Option::Some(#start..#end))
        }
    };
    quote!(::residua::description::Unknown { name: #name, len: #len, measure: #measure })
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
