//! What no tool can decide: labels, words and typography, read by eye.
//!
//! The paper was read as text extracted from its pages, so where a sign may have got lost on that way, the
//! entry says so.

use serde::Serialize;

/// A slip that was found by reading.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
pub struct Slip {
    /// Where.
    pub place: &'static str,
    /// What is printed.
    pub printed: &'static str,
    /// What is right.
    pub right: &'static str,
    /// Why.
    pub reason: &'static str,
    /// It may be a mistake of the extracted text instead of the paper.
    pub doubtful: bool,
}

/// All of them, in the order of the paper.
pub const SLIPS: &[Slip] = &[
    Slip {
        place: "Eqs. (5), (7)",
        printed: "R_x(θ3) in θ1, R_z(θ1) in θ3",
        right: "R_x(θ1), R_z(θ3)",
        reason: "the arguments on the left are not those on the right; (9) has R_x in θ1 and R_z in θ3",
        doubtful: false,
    },
    Slip {
        place: "Eq. (11)",
        printed: "S_x, S_y, S_z",
        right: "S(e1), S(e2), S(e3)",
        reason: "the names of Eq. (8); S_x is not defined",
        doubtful: false,
    },
    Slip {
        place: "Eqs. (8), (11) and (13), (14)",
        printed: "ω_x, ω_y, ω_z for the rates of the three angles and for the components of ω",
        right: "two sets of names",
        reason: "Eq. (15) says how they differ",
        doubtful: false,
    },
    Slip {
        place: "below Eq. (9)",
        printed: "the Lie algebra which corresponds to R_x, R_y, R_z is θe1, θe2, θe3",
        right: "θ1e1, θ2e2, θ3e3",
        reason: "three angles, as in Eq. (9)",
        doubtful: false,
    },
    Slip {
        place: "Eq. (16)",
        printed: "‖R‖ = 1",
        right: "det R = 1",
        reason: "the spectral norm is 1 wherever R Rᵀ = I and tells no rotation from a reflection, and the root of \
                 the sum of squares is √3",
        doubtful: false,
    },
    Slip {
        place: "above Eq. (19)",
        printed: "Γi = Rᵀe3",
        right: "Γi = Rᵀei",
        reason: "there are three of them; the text above Eq. (32) has it right",
        doubtful: false,
    },
    Slip {
        place: "Eq. (19)",
        printed: "Γ1 = S(Γ1)ω and so on",
        right: "Γ̇1 = S(Γ1)ω and so on",
        reason: "it is called the derivation of Γ",
        doubtful: true,
    },
    Slip {
        place: "below Eq. (19)",
        printed: "in space, Eq. (19) needs to be completely solved to obtain R",
        right: "two of the three rows suffice: Γ1 = Γ2 × Γ3",
        reason: "the rows of a rotation are a right-handed orthonormal basis",
        doubtful: false,
    },
    Slip {
        place: "above Eqs. (21), (22)",
        printed: "the Rodriguez parameter or Cayley transformation, as in (21) and (22), respectively",
        right: "Rodrigues’ formula (21); the Rodrigues parameters tan(φ/2)n belong to the Cayley transformation (22)",
        reason: "(21) is in the rotation vector, the η of (22) are the parameters",
        doubtful: false,
    },
    Slip {
        place: "Eqs. (20), (22)",
        printed: "one η for the Lie algebra element and the Cayley vector",
        right: "two names, η and tan(‖η‖/2) η/‖η‖",
        reason: "exp S(η) and cay S(η) differ, see the claims of Eq. 22",
        doubtful: false,
    },
    Slip {
        place: "above Eq. (23)",
        printed: "for i = j R_a and R_b are called isomorphism",
        right: "they belong to one one-parameter subgroup",
        reason: "an isomorphism is a map between groups; rotations about different axes form isomorphic groups as well",
        doubtful: false,
    },
    Slip {
        place: "below Eq. (23)",
        printed: "R_a and R_b commute if and only if i = j",
        right: "for all angles if and only if i = j",
        reason: "half turns about perpendicular axes commute, and so does the identity with every rotation",
        doubtful: false,
    },
    Slip {
        place: "Section 3",
        printed: "transforms the ODE into nonlinear equations, which reduces the error of each step to the lowest \
                  level and avoids error accumulation",
        right: "Newton's method removes the error of solving the step, not that of the discretisation",
        reason: "the discretisation error of a step is O(h³) however well its equations are solved",
        doubtful: false,
    },
    Slip {
        place: "text from Eq. (28) on",
        printed: "\"Equation (28)\" for (27), \"Equation (50)\" for (49), and so on up to \"Equation (87)\" for (86)",
        right: "the number of the tag",
        reason: "references in the text run one ahead of the tags; \"The Jacobi matrix is Equation (87)\" does not",
        doubtful: false,
    },
    Slip {
        place: "above Eq. (36)",
        printed: "the above expression can also transform to be exponential in type",
        right: "Eq. (34) can",
        reason: "the expression above is (35), a mean; (36) is R[k+1] = R[k]F[k] with F = exp S(Δη)",
        doubtful: false,
    },
    Slip {
        place: "Eqs. (36), (37)",
        printed: "stated for any η",
        right: "for rotations about one axis",
        reason: "contradicts the text below Eq. (24) and the one above Eq. (84), \"not exchangeable\"",
        doubtful: false,
    },
    Slip {
        place: "Eq. (40)",
        printed: "Π + m g l e2ᵀRe1 = 0",
        right: "Π̇ + m g l e2ᵀRe1 = 0",
        reason: "Π = Jω in Eq. (38)",
        doubtful: true,
    },
    Slip {
        place: "above Eq. (51)",
        printed: "the discretion of ω is Equation (44)",
        right: "tag (44), \"Equation (45)\" as the text counts elsewhere",
        reason: "the one reference that is not one ahead, beside \"Equation (52)\" for (51) in the same sentence",
        doubtful: false,
    },
    Slip {
        place: "Eqs. (50), (52), (53), (58) to (60)",
        printed: "S1",
        right: "S(1), the matrix with the rows (0, −1) and (1, 0)",
        reason: "never defined; S(ω) = ω S1 turns (49) into (52)",
        doubtful: false,
    },
    Slip {
        place: "below Eq. (54)",
        printed: "change into the vector equation via multiplying them by e1 and e2",
        right: "they have been multiplied already; it is S(ω)e1 = ωe2 and S(ω)e2 = −ωe1 that turn (54) into (55)",
        reason: "Eq. (54) prints both factors",
        doubtful: false,
    },
    Slip {
        place: "Eqs. (55), (57)",
        printed: "Γa, Γb for columns of F in (55), for rows of R in (57)",
        right: "two pairs of names",
        reason: "the paper notes it below Eq. (58)",
        doubtful: false,
    },
    Slip {
        place: "above Eq. (60)",
        printed: "if the parameters are ω[k+1/2], Γa[k+1/2], Γb[k+1/2], Eqs. (58) and (59) have the Jacobian (60)",
        right: "its entries contain midpoint values; the unknowns are the next values or the increments",
        reason: "by the midpoint values the derivative is twice Eq. (60)",
        doubtful: false,
    },
    Slip {
        place: "Eq. (64)",
        printed: "e2^{S(θ[k+1]/2)}",
        right: "e^{S(θ[k+1]/2)}",
        reason: "an exponential, not a power of the vector e2",
        doubtful: true,
    },
    Slip {
        place: "Eq. (69)",
        printed: "F^I in its first line",
        right: "Fᵀ",
        reason: "Fᵀ in its second line, and X = FᵀK3 turns it into Eq. (70)",
        doubtful: true,
    },
    Slip {
        place: "above Eq. (69)",
        printed: "Let Ṙᵀe3 = −S(ω)Rᵀe3",
        right: "it follows from Ṙ = R S(ω)",
        reason: "Eq. (67), transposed",
        doubtful: false,
    },
    Slip {
        place: "Eqs. (72), (78)",
        printed: "H δ = 0, T δ = 0",
        right: "H δ = −F, T δ = −F",
        reason: "with a regular H the printed one forces δ = 0; Newton's method, Eq. (27), has the residual on the right",
        doubtful: false,
    },
    Slip {
        place: "above Eq. (82)",
        printed: "According to Equation (20)",
        right: "Equation (19)",
        reason: "the rates of Γ1, Γ2, Γ3; one ahead again",
        doubtful: false,
    },
    Slip {
        place: "above Eqs. (82), (83)",
        printed: "the unknowns in the order Δω, ΔΓ3, ΔΓ2, ΔΓ1",
        right: "Δω, ΔΓ1, ΔΓ2, ΔΓ3",
        reason: "the columns of Eq. (83) are in this order; see the claim with the columns of the text",
        doubtful: false,
    },
    Slip {
        place: "T4 of Eq. (82)",
        printed: "4 + 2hS(ω)",
        right: "4I + 2hS(ω)",
        reason: "a number and a matrix have no sum; see the claim that adds it to every entry",
        doubtful: false,
    },
    Slip {
        place: "above Eq. (84)",
        printed: "the Cardan transformation R = R_x R_y R_z",
        right: "(10), (12), (15), lines 1 and 3 of Eq. (84) and R0 have it; line 2, (86) and (87) have R = R_z R_y R_x",
        reason: "see the claims of Eqs. 84, 86 and 87 in spatial_cardan, and in spatial_cardan_zyx, where they are right",
        doubtful: false,
    },
    Slip {
        place: "above Eq. (84)",
        printed: "as the group is not exchangeable, discretizing the Lie group directly is not available",
        right: "discretising the Lie algebra by sums, as in Eqs. (36) and (37), is not available",
        reason: "Eq. (82) does discretise the group directly; and the algebra works too with a product of exponentials, R[k+1] = R[k] exp S(hω), which is the model spatial_exponential",
        doubtful: false,
    },
    Slip {
        place: "above Eq. (86)",
        printed: "Substitute the former into Equation (86)",
        right: "into Equation (85) as the text counts, which is tag (84)",
        reason: "by that count Equation (86) is the former, the discrete rules, themselves",
        doubtful: false,
    },
    Slip {
        place: "below Eq. (86)",
        printed: "The dimensions of Equation (87) number 6, and Δω, Δθx, Δθy, Δθz are their variables. The Jacobi \
                  matrix is Equation (87).",
        right: "of Equation (86); the Jacobian is Equation (87)",
        reason: "one number for two equations",
        doubtful: false,
    },
    Slip {
        place: "Eq. (87)",
        printed: "u11 to u24 in the matrix, U11 to U24 below",
        right: "one spelling",
        reason: "they are the same blocks",
        doubtful: true,
    },
    Slip {
        place: "Section 6, on Figures 18 and 19",
        printed: "based on Equation (70)",
        right: "tag (69), if the text counts one ahead as elsewhere; what can be solved is (70)",
        reason: "(78), (83) and (87) in the same section are tags (77), (82) and (86). Of the F in (69) its equations determine Fᵀ K3 alone, the X of (70)",
        doubtful: false,
    },
];
