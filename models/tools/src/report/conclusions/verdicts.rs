//! The conclusions, judged.

use super::super::measure::COINCIDE;
use super::super::measure::Measure;
use super::super::page::Judgement;
use super::super::page::Verdict;
use super::evidence::CARDAN_STEP;
use super::evidence::Evidence;
use super::evidence::KEPT;
use super::evidence::PLANAR_END;
use super::evidence::PLANAR_STEPS;
use super::evidence::SPATIAL_END;
use super::evidence::SPATIAL_STEPS;
use super::evidence::found;
use super::evidence::largest;
use super::evidence::of;
use super::evidence::percent;
use super::evidence::pick;
use crate::notation::rounded;
use crate::study::Found;

impl Evidence {
    pub(super) fn first(&self) -> Verdict {
        let runge_kutta = pick(&self.runge_kutta, "planar_angle", 0.1);
        let angle = self.planar("planar_angle", 0.1);
        let loses = -runge_kutta.amplitude_change > COINCIDE;
        let keeps = self
            .planar
            .iter()
            .all(|m| m.amplitude_change.abs() < COINCIDE);
        let late = self.planar.iter().all(|m| m.lag.abs() > 0.0);
        Verdict {
            judgement: match loses && keeps && late {
                true => Judgement::HoldsWhen,
                false => Judgement::DoesNotHold,
            },
            statement:
                "Conclusion 1: over a long time errors show in the amplitude and in the period."
                    .to_owned(),
            reason: format!(
                "the method dissipates, as Runge–Kutta 4 does: at h = 0.1 s it loses {} of the amplitude in 50 s and is \
                 {} s off. The paper’s own schemes are symmetric in time: at the same step the angle form is {} s \
                 off, and none of them changes the amplitude by more than {} at any step tested. Their errors are \
                 in the period alone.",
                percent(-runge_kutta.amplitude_change),
                rounded(runge_kutta.lag.abs(), 2),
                rounded(angle.lag.abs(), 2),
                percent(largest(
                    self.planar.iter().map(|m| m.amplitude_change.abs())
                )),
            ),
        }
    }

    pub(super) fn second(&self) -> Verdict {
        let reduced: Vec<&Measure> = of(&self.planar, "planar_reduced");
        let energy = largest(reduced.iter().map(|m| m.energy_error));
        let (coarse, fine) = (
            self.planar("planar_reduced", 0.05),
            self.planar("planar_reduced", 0.01),
        );
        let ratio = coarse.lag / fine.lag;
        Verdict {
            judgement: match energy < KEPT {
                true => Judgement::HoldsWhen,
                false => Judgement::DoesNotHold,
            },
            statement: "Conclusion 2: the reduced attitude keeps its character over a long time at a suitable step; \
                        else it lags, and how fast depends on the step."
                .to_owned(),
            reason: format!(
                "“character” means the phase. Energy and |Γ| are kept to rounding at every step (energy within {} of \
                 the swing’s, for h from 0.1 to 0.01 s): there is no special step. What depends on it is the lag, {} s at \
                 h = 0.05 s and {} s at 0.01 s after 50 s, a ratio of {} where h² predicts 25.",
                rounded(energy, 2),
                rounded(coarse.lag, 3),
                rounded(fine.lag, 3),
                rounded(ratio, 3),
            ),
        }
    }

    pub(super) fn third(&self) -> Verdict {
        let lag = |model: &str, step: f64| rounded(self.planar(model, step).lag, 3);
        let same = PLANAR_STEPS.iter().all(|&step| {
            let (group, reduced) = (
                self.planar("planar_group", step),
                self.planar("planar_reduced", step),
            );
            (group.lag - reduced.lag).abs() <= KEPT * PLANAR_END
        });
        let (group, algebra) = (
            self.planar("planar_group", 0.05).lag.abs(),
            self.planar("planar_algebra", 0.05).lag.abs(),
        );
        let (large_group, large_algebra) = (
            found(&self.large, "planar_group"),
            found(&self.large, "planar_algebra"),
        );
        let shift = |row: &Found| row.ahead.unwrap_or(f64::INFINITY);
        let energy = |row: &Found| row.invariants.first().map_or(0.0, |w| w.largest);
        let better_small = group < 0.5 * algebra;
        let better_large = shift(large_group).abs() < 0.5 * shift(large_algebra).abs();
        Verdict {
            judgement: match (better_small, better_large) {
                (true, true) => Judgement::Holds,
                (false, true) => Judgement::HoldsWhen,
                (_, false) => Judgement::DoesNotHold,
            },
            statement: "Conclusion 3: the complete Lie group is not sensitive to the step, the Lie algebra is.".to_owned(),
            reason: format!(
                "the swing is large, and “not sensitive” means less so: both go with h². On the paper’s swing, after 50 s at \
                 h = 0.05 and 0.01 s, the complete group lags {} and {} s, the Lie algebra {} and {} s: no difference. On one \
                 of 163° at h = 0.01 s the group is {} s ahead and the Lie algebra {} s, with energy errors of {} and {} J. \
                 Complete group and reduced attitude {}; the rows of R that are added do not act back.",
                lag("planar_group", 0.05),
                lag("planar_group", 0.01),
                lag("planar_algebra", 0.05),
                lag("planar_algebra", 0.01),
                rounded(shift(large_group), 2),
                rounded(shift(large_algebra), 2),
                rounded(energy(large_group), 1),
                rounded(energy(large_algebra), 2),
                if same { "take the same steps" } else { "differ" },
            ),
        }
    }

    pub(super) fn fourth(&self) -> Verdict {
        let model = "spatial_group";
        let (coarse, fine) = (self.spatial(model, 0.1), self.spatial(model, 0.01));
        let stays = coarse.last_share() < COINCIDE && fine.last_share() < COINCIDE;
        Verdict {
            judgement: Judgement::of(stays),
            statement: "Conclusion 4: in space, reduced attitude and complete group depend little on the step; 0.1 and \
                        0.01 s are not obviously distinguishable."
                .to_owned(),
            reason: format!(
                "The swing at h = 0.1 s parts visibly from the exact one after {} s, at 0.01 s after {} s. At the end the \
                 first lags {} s and the second {} s, of a period of {} s. What does not depend on the step is \
                 the amplitude: the energy is kept to {} of the swing’s.",
                rounded(coarse.coincides_until, 2),
                rounded(fine.coincides_until, 2),
                rounded(coarse.lag, 3),
                rounded(fine.lag, 3),
                rounded(self.period, 3),
                rounded(coarse.energy_error.max(fine.energy_error), 1),
            ),
        }
    }

    pub(super) fn fifth(&self) -> Verdict {
        let at = |step: f64| self.spatial("spatial_cardan", step);
        let (coarse, paper, fine) = (at(0.01), at(CARDAN_STEP), at(0.001));
        let group = self.spatial("spatial_group", 0.005);
        let bounded = SPATIAL_STEPS
            .iter()
            .filter(|step| **step <= 0.01)
            .all(|&step| at(step).energy_error < COINCIDE);
        Verdict {
            judgement: match bounded && coarse.off_axis > COINCIDE {
                true => Judgement::HoldsWhen,
                false => Judgement::DoesNotHold,
            },
            statement:
                "Conclusion 5: with Cardan angles the motion in space loses its conservation."
                    .to_owned(),
            reason: format!(
                "“conservation” means the vertical angular momentum. With R = Rx Ry Rz the energy stays within {} at h = 0.01 s \
                 and {} at 0.005 s, and no step fails. But a midpoint rule in (ω, θ) conserves quadratic functions of its \
                 unknowns only, and Γ(θ)·J ω is none; so the momentum about the vertical drifts, and the plane of the swing \
                 turns: the part of ω off its axis reaches {} at h = 0.01 s, {} at 0.005 s and {} at 0.001 s, against {} for \
                 the complete group at 0.005 s. A smaller step delays that. It is not the singularity (|θy| stays below \
                 {}°), not Newton ({} iterations a step) and not rounding. Eq. 86 as printed is the same rule for R = Rz Ry Rx, \
                 which contradicts the start R0 = Rx Ry Rz: see Figures 26 and 27 and the errata.",
                percent(coarse.energy_error),
                percent(paper.energy_error),
                percent(coarse.off_axis),
                percent(paper.off_axis),
                percent(fine.off_axis),
                percent(group.off_axis),
                rounded(self.tilt, 3),
                rounded(paper.iterations, 2),
            ),
        }
    }

    pub(super) fn summary(&self) -> Verdict {
        let group = self.spatial("spatial_group", 0.01);
        let reduced = self.spatial("spatial_reduced", 0.01);
        let apart = (group.lag - reduced.lag).abs();
        let of = |model: &str| found(&self.space, model);
        let error = |row: &Found| rounded(row.errors[0], 2);
        let runge_kutta = self.space.iter().filter(|row| row.method == "RK4");
        let explicit = runge_kutta.filter_map(|row| row.found.as_ref().ok());
        let explicit = explicit
            .map(|row| row.errors[0])
            .fold(f64::INFINITY, f64::min);
        Verdict {
            judgement: Judgement::of(apart > KEPT * SPATIAL_END),
            statement: "In sum: the complete Lie group has the best long time behaviour and depends least on the step."
                .to_owned(),
            reason: format!(
                "It is the reduced attitude with passengers: at h = 0.01 s both lag {} s after 100 s, and it costs more per step. \
                 What the midpoint rule on R gives is energy, constraint and momentum to rounding, at any step. Where the \
                 phase counts, others are closer at the same step: on this scene the largest error is {} for the complete \
                 group, {} where the attitude is advanced by exp, and {} for Runge–Kutta 4, whose energy drifts. So choose by \
                 what is to be kept; for the invariants the reduced attitude or, with all of R, the recursive form.",
                rounded(group.lag, 4),
                error(of("spatial_group")),
                error(of("spatial_exponential")),
                rounded(explicit, 2),
            ),
        }
    }
}
