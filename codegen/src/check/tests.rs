//! Good models and what is known about them afterwards. Mistakes are in `codegen/tests/diagnostics`.

use crate::ast::ExprId;
use crate::ast::Form;
use crate::ast::Level;
use crate::model::Model;
use crate::model::Op;
use crate::model::Shape;
use crate::model::Solved;
use crate::parse;

const PLANAR: &str = r#"
    /// Planar pendulum, reduced attitude.
    param m: kg        = 2;
    param J: kg*m^2    = 0.48;      // about the pivot
    param l: m         = 0.6;
    param g: m/s^2     = 9.81;

    state ω: 1/s;                   // scalar
    state Γ: [2];                   // [n] vector, [n,m] matrix, dimensionless

    let e1 = [1, 0];

    flow {                          // the continuous equations
        J*der(ω) = -m*g*l*e1.T*Γ;
        der(Γ)   = -S(ω)*Γ;
    }

    residual {                      // the discrete ones, as printed
        2*J*(ω[k+1] - ω) + h*m*g*l*e1.T*(Γ[k+1] + Γ) = 0;
        4*(Γ[k+1] - Γ) + h*S(ω[k+1] + ω)*(Γ[k+1] + Γ) = 0;
    }
    solve for next, increment;      // both difference forms of the paper from one text

    start { ω = 1; Γ = [0, 1]; }

    invariant energy: J = J*ω^2/2 - m*g*l*[0,1].T*Γ;
    invariant norm      = Γ.T*Γ;
    observe  θ: rad     = atan2(Γ.x, Γ.y);

    claim jacobian "Eq. 50" {
        [[2*J, h*m*g*l*e1.T], [h*S(1)*(Γ[k+1]+Γ), 4*I + h*S(ω[k+1]+ω)]]
    }
"#;

const SPATIAL: &str = r"
    //! 3D pendulum on the rotation group.
    /// Inertia.
    param J: kg*m^2 = diag(1, 2.8, 2);
    param m: kg = 1;
    param g: m/s^2 = 9.81;
    param ρ: [3] m = [0, 0, 0.3];
    let τ = m*g*cross(ρ, R.T*e3);
    let e3 = [0, 0, 1];
    state R: [3, 3];
    state ω: [3] 1/s;
    unknown F: [3, 3] = I;
    residual {
        J*Δω + h*cross(ω[k+1/2], J*ω[k+1/2]) - h*τ = 0;
        F - I - h*S(ω[k+1/2])*(F + I)/2 = 0;
    }
    update { R = R*F; ω = ω + Δω; }
    start { R = Rx(pi/3); ω = [0.5, -0.5, 0.4]; }
    invariant energy: J = ω.T*J*ω/2 - m*g*ρ.T*R.T*e3;
    observe trace_R = trace(R);
";

fn model(text: &str) -> Model {
    let tokens = text.parse().expect("lexes");
    let ast = parse::parse("test", tokens).unwrap_or_else(|e| panic!("{e}"));
    super::check(&ast).unwrap_or_else(|e| panic!("{e}"))
}

#[test]
fn the_planar_pendulum_is_right() {
    let model = model(PLANAR);
    assert_eq!(model.doc.len(), 1);
    assert_eq!(model.n_unknowns(), 3);
    assert_eq!(model.forms, [Form::Next, Form::Increment]);
    assert_eq!(model.solved, [Solved::State(0), Solved::State(1)]);
    assert_eq!(model.residual[1].shape, Shape::vector(2));
    assert_eq!(
        model.residual[0].text,
        "2*J*(ω[k+1] - ω) + h*m*g*l*e1.T*(Γ[k+1] + Γ) = 0"
    );
    assert_eq!(model.outputs[0].variable.unit.to_string(), "kg*m^2/s^2");
    assert_eq!(model.outputs[2].variable.name.ascii, "theta");
    assert_eq!(model.claims[0].blocks[1][0].1, "h*S(1)*(Γ[k+1]+Γ)");
}

#[test]
fn the_spatial_pendulum_mixes_solved_and_own_unknowns() {
    let model = model(SPATIAL);
    assert_eq!(model.doc, ["3D pendulum on the rotation group."]);
    assert_eq!(model.parameters[0].variable.doc, ["Inertia."]);
    assert_eq!(model.parameters[0].variable.shape.len(), 9);
    assert_eq!(model.solved, [Solved::State(1), Solved::Own(0)]);
    assert!(!model.states[0].solved && model.states[1].solved);
    assert_eq!(model.states[1].variable.offset, 9);
    assert_eq!(model.n_unknowns(), 12);
}

#[test]
fn operands_come_before_users() {
    for text in [PLANAR, SPATIAL] {
        for (i, expr) in model(text).exprs.iter().enumerate() {
            let before = |id: &ExprId| id.index() < i;
            assert!(expr.op.operands().iter().all(before));
        }
    }
}

#[test]
fn a_let_used_twice_is_one_expression() {
    let model = model(
        "state x; let a = x[k+1] + x;
         residual { a*a = 0; } start { x = 1; }",
    );
    let Op::Mul(left, right) = model.expr(model.residual[0].lhs).op else {
        panic!("a product");
    };
    assert_eq!(left, right);
    let next = |e: &&crate::model::Expr| matches!(e.op, Op::State(0, Level::Next));
    assert_eq!(model.exprs.iter().filter(next).count(), 1);
}
