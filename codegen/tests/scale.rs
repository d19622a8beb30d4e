//! What the generator makes of large models: as much as they need, by counts of nodes and operations.

use residua_codegen::Analysis;
use residua_codegen::analyse;
use residua_codegen::schedule::Schedule;
use residua_codegen::schedule::Solver;
use residua_codegen::source::lex;
use residua_codegen::stage::program;

/// Operations of a dense solve of 12 unknowns, 2n³/3 + 2n²: what a closed form may take besides four times the entries
/// of the Jacobian.
const BUDGET: usize = 1440;

/// n masses on a line with forces and inertia between neighbours: M(q) Δv = h f(q), Δq = h v.
fn chain(n: usize) -> String {
    let mut text = String::new();
    for i in 0..n {
        text += &format!("state q{i}; state v{i};\n");
    }
    text += "residual {\n";
    for i in 0..n {
        let (mut inertia, mut force) = (format!("2*Δv{i}"), "0".to_owned());
        for j in [i.wrapping_sub(1), i + 1].into_iter().filter(|&j| j < n) {
            let stretch = format!("(q{i}[k+1/2] - q{j}[k+1/2])");
            inertia += &format!(" + 0.1*cos{stretch}*Δv{j}");
            force += &format!(" - sin{stretch}");
        }
        text += &format!("{inertia} = h*({force});\nΔq{i} = h*v{i}[k+1/2];\n");
    }
    finished(text, n, |i| format!("q{i} = {i}/10; v{i} = 0;"))
}

/// Heat on a rod of n cells: linear and sparse.
fn rod(n: usize) -> String {
    let mut text = String::new();
    for i in 0..n {
        text += &format!("state x{i};\n");
    }
    text += "residual {\n";
    for i in 0..n {
        let mut flow = "0".to_owned();
        for j in [i.wrapping_sub(1), i + 1].into_iter().filter(|&j| j < n) {
            flow += &format!(" + x{j}[k+1/2] - x{i}[k+1/2]");
        }
        text += &format!("Δx{i} = h*({flow});\n");
    }
    finished(text, n, |i| format!("x{i} = {i}/10;"))
}

/// n linear equations, each with all unknowns.
fn dense(n: usize) -> String {
    let text = format!("param A: [{n},{n}] = I; state x: [{n}]; residual {{ Δx = h*A*x[k+1/2];\n");
    finished(text, 1, |_| format!("x = {};", ones(n)))
}

/// n masses, each with a spring to each other.
fn springs(n: usize) -> String {
    let text = format!(
        "param K: [{n},{n}] = I; state q: [{n}]; state v: [{n}];
         residual {{ Δq = h*v[k+1/2]; Δv = -h*K*q[k+1/2];\n"
    );
    finished(text, 1, |_| format!("q = {}; v = {};", ones(n), ones(n)))
}

/// n equations of third degree, each with all unknowns.
fn cubic(n: usize) -> String {
    let text = format!(
        "param A: [{n},{n}] = I; state x: [{n}];
         residual {{ Δx = -h*A*(x[k+1/2].T*x[k+1/2])*x[k+1/2];\n"
    );
    finished(text, 1, |_| format!("x = {};", ones(n)))
}

fn ones(n: usize) -> String {
    format!("[{}]", vec!["1"; n].join(", "))
}

fn finished(text: String, n: usize, start: impl Fn(usize) -> String) -> String {
    let start: Vec<String> = (0..n).map(start).collect();
    format!(
        "{text}}}\nsolve for increment;\nstart {{ {} }}",
        start.join(" ")
    )
}

fn analysis(text: &str) -> Analysis {
    match analyse("scale", lex(text).expect("lexes")) {
        Ok(analysis) => analysis,
        Err(errors) => panic!("{errors}"),
    }
}

fn solver(analysis: &Analysis) -> Solver {
    program(&analysis.equations, &analysis.systems, None)
        .solvers
        .remove(0)
}

fn n_nodes(analysis: &Analysis) -> usize {
    analysis.systems[0].dag.nodes().len()
}

/// Additions, multiplications, divisions and calls of all functions.
fn operations(schedule: &Schedule) -> usize {
    let counts = schedule.kernels.iter().map(|kernel| schedule.count(kernel));
    let sum = |c: residua_codegen::schedule::Count| {
        c.additions + c.multiplications + c.divisions + c.calls
    };
    counts.map(sum).sum()
}

/// The number of unknowns that are left; all if nothing is eliminated.
fn n_left(solver: &Solver) -> usize {
    let left = solver.core.as_deref().unwrap_or(solver);
    left.unknowns.len()
}

#[test]
fn chains_of_any_length_keep_their_velocities_alone() {
    for n in [4, 6, 7, 20, 60] {
        assert_eq!(n_left(&solver(&analysis(&chain(n)))), n, "{n} masses");
    }
}

#[test]
fn code_for_chains_grows_with_their_length() {
    let [(short, short_nodes), (long, long_nodes)] = [20, 60].map(|n| {
        let analysis = analysis(&chain(n));
        let solver = solver(&analysis);
        let core = solver.core.as_ref().expect("a core");
        (operations(&core.schedule), n_nodes(&analysis))
    });
    // The ends of a chain have less, so three times the length has a little more than three times the code.
    assert!(long < 31 * short / 10, "{short} to {long} operations");
    assert!(
        long_nodes < 31 * short_nodes / 10,
        "{short_nodes} to {long_nodes} nodes"
    );
}

#[test]
fn sparse_linear_systems_of_any_size_have_closed_forms() {
    let [short, long] = [20, 100].map(|n| {
        let solver = solver(&analysis(&rod(n)));
        assert_eq!(n_left(&solver), 0, "{n} cells");
        operations(&solver.core.expect("a core").schedule)
    });
    assert!(long < 52 * short / 10, "{short} to {long} operations");
}

#[test]
fn small_dense_systems_have_closed_forms_and_large_ones_have_not() {
    for n in [3, 10, 12] {
        let analysis = analysis(&dense(n));
        let solver = solver(&analysis);
        assert_eq!(n_left(&solver), 0, "{n} unknowns");
        let own = operations(&solver.core.as_ref().expect("a core").schedule);
        // Setting up the equations and the growth of rounding errors take as much again.
        assert!(own < 2 * BUDGET, "{n} unknowns take {own} operations");
    }
    for n in [13, 20, 30] {
        let analysis = analysis(&dense(n));
        assert_eq!(n_left(&solver(&analysis)), n, "{n} unknowns");
        // For each entry of A itself, h A, its product with x and the entry of the Jacobian, some with a multiple; a few
        // per equation.
        let nodes = n_nodes(&analysis);
        assert!(nodes < 7 * n * n, "{n} unknowns give {nodes} nodes");
    }
}

#[test]
fn positions_are_eliminated_whatever_the_forces_are() {
    for n in [7, 15, 40] {
        let analysis = analysis(&springs(n));
        let solver = solver(&analysis);
        let left = if n <= 12 { 0 } else { n };
        assert_eq!(n_left(&solver), left, "{n} masses");
        let (all, core) = (
            &solver.schedule,
            &solver.core.as_ref().expect("a core").schedule,
        );
        let most = operations(all) + BUDGET + 4 * n * n;
        assert!(operations(core) < most, "{} of {most}", operations(core));
    }
}

#[test]
fn equations_without_linear_unknowns_are_left_alone() {
    let [small, large] = [10, 20].map(|n| {
        let analysis = analysis(&cubic(n));
        assert_eq!(n_left(&solver(&analysis)), n);
        n_nodes(&analysis)
    });
    // Each of the n² entries of the Jacobian has n terms.
    assert!(large < 8 * small, "{small} to {large} nodes");
}
