//! The model that is left: fewer variables, fewer equations, and graphs over those.

use super::Solver;
use super::needs::Needs;
use super::needs::leaves;
use super::zeros::Zeros;
use crate::ast::Name;
use crate::dag::Dag;
use crate::dag::Leaf;
use crate::dag::NodeId;
use crate::model::Equation;
use crate::model::Model;
use crate::model::Output;
use crate::model::Parameter;
use crate::model::Requirement;
use crate::model::Shape;
use crate::model::Solved;
use crate::model::State;
use crate::model::Unknown;
use crate::model::Variable;
use crate::scene::Wishes;
use crate::system::Discrete;
use crate::system::Equations;

/// What is left, and where it came from.
pub(super) struct Left {
    pub(super) model: Model,
    pub(super) equations: Equations,
    pub(super) discrete: Discrete,
    /// For each component of the state its old position.
    pub(super) states: Vec<usize>,
}

/// A state that is left: a variable, or a component of one.
struct Piece {
    /// Which of the old states.
    old: usize,
    /// Which of its components, if not all.
    component: Option<usize>,
}

/// The model with nothing in it but what is needed.
pub(super) fn narrow(
    model: &Model,
    equations: &Equations,
    solver: &Solver,
    zeros: &Zeros,
    needs: &Needs,
    wishes: &Wishes,
) -> Left {
    let pieces = pieces(model, zeros, needs, wishes);
    let mut narrowed = Model {
        parameters: parameters(model, wishes),
        states: states(model, &pieces),
        unknowns: Vec::new(),
        solved: Vec::new(),
        absent: Vec::new(),
        residual: residual(model, &needs.rows),
        outputs: outputs(model, wishes),
        forms: vec![wishes.form],
        claims: Vec::new(),
        requirements: Vec::new(),
        ..model.clone()
    };
    add_unknowns(model, &pieces, needs, &mut narrowed);
    let old_states: Vec<usize> = pieces.iter().flat_map(|p| components(model, p)).collect();
    let places = Places::new(model, &old_states, zeros, needs, wishes);
    let is_wanted = |i: &usize| output_is_wanted(model, wishes, *i);
    let outputs = (0..equations.outputs.len()).filter(is_wanted);
    let outputs: Vec<NodeId> = outputs.map(|i| equations.outputs[i]).collect();
    let flow = flow(equations, &old_states, zeros);
    if flow.is_none() {
        narrowed.flow.clear();
    }
    let requirements = model.requirements.iter().zip(&equations.requirements);
    let (kept, sides): (Vec<&Requirement>, Vec<&Vec<NodeId>>) = requirements
        .filter(|(_, sides)| is_closed(&equations.dag, sides, &old_states))
        .unzip();
    narrowed.requirements = kept.into_iter().cloned().collect();
    let left_equations = places.equations(equations, &old_states, &outputs, &sides, flow);
    let discrete = places.discrete(solver, &old_states, needs, wishes);
    Left {
        model: narrowed,
        equations: left_equations,
        discrete,
        states: old_states,
    }
}

/// The states that are left. A variable stays whole where all its components are needed or 0.
fn pieces(model: &Model, zeros: &Zeros, needs: &Needs, wishes: &Wishes) -> Vec<Piece> {
    let mut pieces = Vec::new();
    for (old, state) in model.states.iter().enumerate() {
        let own = own(&state.variable);
        let is_there = wishes.states[old] || own.clone().any(|i| needs.states[i]);
        let is_whole = own.clone().all(|i| needs.states[i] || zeros.states[i]);
        if is_there && is_whole {
            pieces.push(Piece {
                old,
                component: None,
            });
        } else {
            let needed = own.clone().filter(|&i| needs.states[i]);
            pieces.extend(needed.map(|i| Piece {
                old,
                component: Some(i - own.start),
            }));
        }
    }
    pieces
}

/// The positions of a variable's components.
pub(super) fn own(variable: &Variable) -> std::ops::Range<usize> {
    variable.offset..variable.offset + variable.shape.len()
}

/// The old positions of a piece.
fn components(model: &Model, piece: &Piece) -> Vec<usize> {
    let own = own(&model.states[piece.old].variable);
    match piece.component {
        None => own.collect(),
        Some(component) => vec![own.start + component],
    }
}

fn parameters(model: &Model, wishes: &Wishes) -> Vec<Parameter> {
    let parameters = model.parameters.iter().zip(&wishes.fixed);
    let left = parameters.filter(|(_, fixed)| fixed.is_none());
    let mut left: Vec<Parameter> = left.map(|(p, _)| p.clone()).collect();
    number(left.iter_mut().map(|p| &mut p.variable));
    left
}

fn outputs(model: &Model, wishes: &Wishes) -> Vec<Output> {
    let outputs = model.outputs.iter().zip(&wishes.outputs);
    let mut left: Vec<Output> = outputs.filter(|o| *o.1).map(|o| o.0.clone()).collect();
    number(left.iter_mut().map(|o| &mut o.variable));
    left
}

fn output_is_wanted(model: &Model, wishes: &Wishes, position: usize) -> bool {
    let mut outputs = model.outputs.iter().zip(&wishes.outputs);
    outputs.any(|(o, wanted)| *wanted && own(&o.variable).contains(&position))
}

fn states(model: &Model, pieces: &[Piece]) -> Vec<State> {
    let state = |piece: &Piece| {
        let mut state = model.states[piece.old].clone();
        if let Some(component) = piece.component {
            state.variable = scalar(model, &state.variable, component);
        }
        state
    };
    let mut states: Vec<State> = pieces.iter().map(state).collect();
    number(states.iter_mut().map(|s| &mut s.variable));
    states
}

fn number<'a>(variables: impl Iterator<Item = &'a mut Variable>) {
    let mut offset = 0;
    for variable in variables {
        variable.offset = offset;
        offset += variable.shape.len();
    }
}

/// A component as a variable of its own: `R(2,1)`, in ASCII `R_2_1`; `Γ.y` is `Gamma_y`.
fn scalar(model: &Model, variable: &Variable, component: usize) -> Variable {
    let Shape { cols, .. } = variable.shape;
    let Name {
        ascii,
        display,
        range,
    } = &variable.name;
    let (row, col) = (component / cols + 1, component % cols + 1);
    let suffix = variable.component_suffix(component);
    let (shown, mut ascii) = match cols {
        1 => (
            suffix.clone(),
            format!("{ascii}{}", suffix.replace('.', "_")),
        ),
        _ => (format!("({row},{col})"), format!("{ascii}_{row}_{col}")),
    };
    while is_taken(model, &ascii) {
        ascii.push('_');
    }
    Variable {
        name: Name {
            ascii,
            display: format!("{display}{shown}"),
            range: *range,
        },
        shape: Shape::SCALAR,
        ..variable.clone()
    }
}

fn is_taken(model: &Model, ascii: &str) -> bool {
    let parameters = model.parameters.iter().map(|p| &p.variable);
    let states = model.states.iter().map(|s| &s.variable);
    let unknowns = model.unknowns.iter().map(|u| &u.variable);
    let mut all = parameters.chain(states).chain(unknowns);
    all.any(|v| v.name.ascii == ascii)
}

/// The equations of the rows that are left; of part of an equation, row by row.
fn residual(model: &Model, rows: &[bool]) -> Vec<Equation> {
    let mut left = Vec::new();
    let mut offset = 0;
    for equation in &model.residual {
        let own = offset..offset + equation.shape.len();
        offset = own.end;
        if own.clone().all(|row| rows[row]) {
            left.push(equation.clone());
            continue;
        }
        left.extend(own.clone().filter(|&row| rows[row]).map(|row| Equation {
            shape: Shape::SCALAR,
            text: format!("row {} of {}", row - own.start + 1, equation.text),
            ..equation.clone()
        }));
    }
    left
}

/// The blocks of unknowns that are left, in their old order.
fn add_unknowns(model: &Model, pieces: &[Piece], needs: &Needs, narrowed: &mut Model) {
    let mut offset = 0;
    for &solved in &model.solved {
        let variable = model.solved_variable(solved);
        let start = offset;
        offset += variable.shape.len();
        let is_needed = |component: usize| needs.unknowns[start + component];
        let all = 0..variable.shape.len();
        match solved {
            Solved::Own(i) if all.clone().any(is_needed) => {
                let new = Solved::Own(narrowed.unknowns.len());
                narrowed.unknowns.push(Unknown {
                    ..model.unknowns[i].clone()
                });
                narrowed.solved.push(new);
                let absent = all.filter(|&c| !is_needed(c)).map(|c| (new, c));
                narrowed.absent.extend(absent);
            }
            Solved::Own(_) => {}
            Solved::State(i) => {
                let own = pieces.iter().enumerate().filter(|(_, p)| p.old == i);
                for (position, piece) in own {
                    let new = Solved::State(position);
                    let parts: Vec<usize> = match piece.component {
                        Some(component) => vec![component],
                        None => all.clone().collect(),
                    };
                    narrowed.solved.push(new);
                    let absent = parts.iter().enumerate().filter(|(_, c)| !is_needed(**c));
                    narrowed.absent.extend(absent.map(|(c, _)| (new, c)));
                }
            }
        }
    }
    number(narrowed.unknowns.iter_mut().map(|u| &mut u.variable));
}

/// The rates of the states that are left, if they depend on no others and zeros stay zeros.
fn flow(equations: &Equations, old_states: &[usize], zeros: &Zeros) -> Option<Vec<NodeId>> {
    let rates = equations.flow.as_ref()?;
    let rates: Vec<NodeId> = old_states.iter().map(|&i| rates[i]).collect();
    let stay = old_states
        .iter()
        .zip(&rates)
        .filter(|(i, _)| zeros.states[**i]);
    let zeros_stay = stay
        .into_iter()
        .all(|(_, &rate)| equations.dag.is_zero(rate));
    (zeros_stay && is_closed(&equations.dag, &rates, old_states)).then_some(rates)
}

/// The states that `roots` depend on are left.
pub(super) fn is_closed(dag: &Dag, roots: &[NodeId], old_states: &[usize]) -> bool {
    leaves(dag, roots).iter().all(|leaf| match leaf {
        Leaf::State(i) => old_states.contains(i),
        _ => true,
    })
}

/// New positions of inputs.
struct Places {
    parameters: Vec<Option<usize>>,
    states: Vec<Option<usize>>,
    unknowns: Vec<Option<usize>>,
}

impl Places {
    fn new(
        model: &Model,
        old_states: &[usize],
        zeros: &Zeros,
        needs: &Needs,
        wishes: &Wishes,
    ) -> Self {
        let is_fixed = super::fold::components(model, wishes);
        let state = |i: usize| old_states.iter().position(|&old| old == i);
        let state = |i| state(i).filter(|_| !zeros.states[i]);
        Self {
            parameters: numbered(is_fixed.iter().map(|fixed| !fixed)),
            states: (0..zeros.states.len()).map(state).collect(),
            unknowns: numbered(needs.unknowns.iter().copied()),
        }
    }

    /// The input at its new position; what has none is 0, and only zeros are asked for without having one.
    fn leaf(&self, dag: &mut Dag, leaf: Leaf) -> NodeId {
        let moved = match leaf {
            Leaf::Parameter(i) => self.parameters[i].map(Leaf::Parameter),
            Leaf::State(i) => self.states[i].map(Leaf::State),
            Leaf::Unknown(i) => self.unknowns[i].map(Leaf::Unknown),
            Leaf::StepSize | Leaf::Time | Leaf::Variation(_) => Some(leaf),
        };
        match moved {
            Some(leaf) => dag.leaf(leaf),
            None => dag.integer(0),
        }
    }

    fn equations(
        &self,
        equations: &Equations,
        old_states: &[usize],
        outputs: &[NodeId],
        requirements: &[&Vec<NodeId>],
        flow: Option<Vec<NodeId>>,
    ) -> Equations {
        let left = self.parameters.iter().zip(&equations.defaults);
        let defaults: Vec<NodeId> = left.filter(|d| d.0.is_some()).map(|d| *d.1).collect();
        let start: Vec<NodeId> = old_states.iter().map(|&i| equations.start[i]).collect();
        let rates = flow.clone().unwrap_or_default();
        let mut dag = Dag::new();
        let zero = dag.integer(0);
        let required: Vec<NodeId> = requirements.iter().copied().flatten().copied().collect();
        let roots = [&defaults, &start, outputs, &required, rates.as_slice()].concat();
        let grafted = dag.graft(&equations.dag, &roots, |dag, leaf| self.leaf(dag, leaf));
        let at = |roots: &[NodeId]| -> Vec<NodeId> {
            let new = |r: &NodeId| grafted[r.index()].unwrap_or(zero);
            roots.iter().map(new).collect()
        };
        Equations {
            defaults: at(&defaults),
            start: at(&start),
            outputs: at(outputs),
            requirements: requirements.iter().map(|sides| at(sides)).collect(),
            flow: flow.as_deref().map(at),
            dag,
        }
    }

    fn discrete(
        &self,
        solver: &Solver,
        old_states: &[usize],
        needs: &Needs,
        wishes: &Wishes,
    ) -> Discrete {
        let kept = |list: &[NodeId], is_kept: &[bool]| {
            let list = list.iter().zip(is_kept).filter(|l| *l.1);
            list.map(|l| *l.0).collect::<Vec<_>>()
        };
        let residual = kept(&solver.residual, &needs.rows);
        let guess = kept(&solver.guess, &needs.unknowns);
        let next: Vec<NodeId> = old_states.iter().map(|&i| solver.next[i]).collect();
        let mut dag = Dag::new();
        let zero = dag.integer(0);
        let roots = [residual.as_slice(), &guess, &next].concat();
        let grafted = dag.graft(&solver.dag, &roots, |dag, leaf| self.leaf(dag, leaf));
        let at = |roots: &[NodeId]| {
            let new = |r: &NodeId| grafted[r.index()].unwrap_or(zero);
            roots.iter().map(new).collect()
        };
        Discrete {
            form: wishes.form,
            residual: at(&residual),
            guess: at(&guess),
            next: at(&next),
            claims: Vec::new(),
            dag,
        }
    }
}

/// The positions of what is there among themselves.
fn numbered(is_there: impl Iterator<Item = bool>) -> Vec<Option<usize>> {
    let mut next = 0;
    let place = |is_there: bool| {
        next += usize::from(is_there);
        is_there.then(|| next - 1)
    };
    is_there.map(place).collect()
}
