//! Which schemes are the same map, and what each conserves.

use super::page::Block;
use super::page::Cell;
use super::page::Data;
use super::page::Section;
use super::page::Table;
use crate::study::Kept;
use crate::study::Map;
use crate::study::Method;
use crate::study::SCENES;
use crate::study::Scene;
use crate::study::conservation;
use crate::study::same_maps;
use indicatif::ProgressBar;
use residua::description::Output;

/// Steps of the runs with h that conservation is judged on.
const STEPS: u64 = 400;

/// Both tables for every system.
pub fn section(progress: &ProgressBar) -> Section {
    let generic: Vec<&Scene> = SCENES.iter().filter(|scene| scene.generic).collect();
    progress.inc_length(generic.len() as u64);
    let mut parts = Vec::new();
    for scene in generic {
        parts.push(part(scene));
        progress.inc(1);
    }
    let text = "Found from the model files alone. What a component of a model is, shows in its course along the \
                continuous equations; then two schemes are the same map if all that both models have agrees to \
                rounding over 40 steps of 0.05 s of a motion without symmetries. Names of states and scalings of \
                equations play no part. An invariant is kept exactly if its drift is rounding at h, h/2 and h/4.";
    Section {
        id: "maps".to_owned(),
        title: "Which schemes are the same, and what they conserve".to_owned(),
        blocks: vec![Block::Text(text.to_owned())],
        parts,
    }
}

fn part(scene: &Scene) -> Section {
    let maps = same_maps(&scene.cases(), scene.until);
    Section {
        id: format!("maps-{}", scene.name),
        title: format!("{}, h = {} s", scene.caption, scene.h),
        blocks: vec![
            Block::List(classes(&maps)),
            Block::Table(differences(scene, &maps)),
            Block::Table(conserved(scene)),
        ],
        parts: Vec::new(),
    }
}

/// `planar_group (next), planar_reduced (next): the same map`
fn classes(maps: &[Map]) -> Vec<String> {
    let mut list = Vec::new();
    for (first, _) in maps.iter().enumerate().filter(|(i, map)| map.class == *i) {
        let members = maps.iter().filter(|map| map.class == first);
        let members: Vec<_> = members.map(name).collect();
        list.push(match members.as_slice() {
            [alone] => format!("{alone}: like no other"),
            _ => format!("{}: one map", members.join(", ")),
        });
    }
    let failed = maps
        .iter()
        .filter_map(|map| Some((name(map), map.error.as_ref()?)));
    list.extend(failed.map(|(name, error)| format!("{name}: no comparison, {error}")));
    list
}

fn name(map: &Map) -> String {
    format!("{} ({})", map.model, map.form)
}

/// The largest difference of each pair.
fn differences(scene: &Scene, maps: &[Map]) -> Table {
    let names: Vec<String> = maps.iter().map(name).collect();
    let head = std::iter::once("scheme").chain(names.iter().map(String::as_str));
    let mut data = Data::new(&head.collect::<Vec<_>>());
    for (i, map) in maps.iter().enumerate() {
        let below = map.differences.iter().map(|pair| {
            let shown = pair.map(|(difference, _)| Cell::number(difference, 1));
            shown.into()
        });
        let above = (i..maps.len()).map(|_| Cell::Empty);
        let cells = std::iter::once(Cell::Text(names[i].clone()));
        data.row(cells.chain(below).chain(above));
    }
    Table {
        csv: format!("maps-{}", scene.name),
        caption: "Largest difference of two schemes over 40 steps of 0.05 s, relative to the size of the variable."
            .to_owned(),
        data,
    }
}

fn conserved(scene: &Scene) -> Table {
    let mut data = Data::new(&[
        "model",
        "form",
        "invariant",
        "kept",
        "order",
        "drift",
        "drift, h/4",
    ]);
    for case in scene.cases() {
        let invariants = case.model.description.outputs.iter();
        if !invariants
            .into_iter()
            .any(|output: &Output| output.invariant)
        {
            continue;
        }
        for method in Method::of(case.model) {
            let model = Cell::Code(case.model.description.name.to_owned());
            match conservation(&case, method, scene.h, STEPS) {
                Ok(list) => list.iter().for_each(|found| {
                    let (kept, order) = match found.kept {
                        Kept::Exactly => ("exactly", None),
                        Kept::ToOrder(order) => ("to the order of the step", Some(order)),
                        Kept::NotAtAll => ("not at all", found.drift.order),
                    };
                    let drift = &found.drift.errors;
                    data.row([
                        model.clone(),
                        method.name().into(),
                        found.name.into(),
                        kept.into(),
                        order.map(|order| Cell::number(order, 3)).into(),
                        Cell::number(drift[0], 2),
                        Cell::number(drift[2], 2),
                    ]);
                }),
                Err(error) => data.row([model, method.name().into(), error.to_string().into()]),
            }
        }
    }
    Table {
        csv: format!("conservation-{}", scene.name),
        caption: format!(
            "What each scheme conserves over {STEPS} steps of {} s.",
            scene.h
        ),
        data,
    }
}
