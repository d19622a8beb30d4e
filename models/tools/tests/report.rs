//! `residua report`, as users run it: the page is sound, and its numbers come out again by other means.

mod support;

use residua::Model as _;
use residua::Stepper;
use residua_models::dsl::planar_reduced::Increment;
use residua_models::dsl::planar_reduced::Model;
use residua_models::dsl::planar_reduced::Parameters;
use residua_tools::report::page::Block;
use residua_tools::report::page::Cell;
use residua_tools::report::page::Data;
use residua_tools::report::page::Page;
use residua_tools::report::page::Section;
use residua_tools::report::page::Table;
use roxmltree::Document;
use roxmltree::Node;
use roxmltree::ParsingOptions;
use serde_json::Value;
use std::collections::BTreeSet;
use std::fs;
use std::path::PathBuf;
use std::sync::OnceLock;
use support::assert_refused;
use support::folder;
use support::residua;
use support::succeed;

/// The folder of a report that all tests read.
fn report() -> &'static PathBuf {
    static REPORT: OnceLock<PathBuf> = OnceLock::new();
    REPORT.get_or_init(|| {
        let folder = folder("report");
        let outcome = succeed(&format!("report --out {}", folder.display()));
        assert_eq!(outcome.stdout, "");
        folder
    })
}

fn html() -> String {
    fs::read_to_string(report().join("index.html")).unwrap()
}

fn parsed(html: &str) -> Document<'_> {
    // A doctype without declarations is all the DTD there is.
    let options = ParsingOptions {
        allow_dtd: true,
        ..ParsingOptions::default()
    };
    Document::parse_with_options(html, options).unwrap()
}

fn named<'a>(document: &'a Document<'a>, name: &'a str) -> impl Iterator<Item = Node<'a, 'a>> {
    let elements = document.descendants();
    elements.filter(move |node| node.tag_name().name() == name)
}

/// The rows of a CSV file of the report, under a value in the column `curve`.
fn rows(file: &str, curve: &str, columns: &[&str]) -> Vec<Vec<f64>> {
    let mut reader = csv::Reader::from_path(report().join(file)).unwrap();
    let head = reader.headers().unwrap().clone();
    let place = |name: &str| head.iter().position(|column| column == name).unwrap();
    let places: Vec<usize> = columns.iter().map(|name| place(name)).collect();
    let records = reader.records().map(Result::unwrap);
    let own = records.filter(|record| &record[place("curve")] == curve);
    let numbers = |record: csv::StringRecord| -> Vec<f64> {
        places.iter().map(|&i| record[i].parse().unwrap()).collect()
    };
    own.map(numbers).collect()
}

#[test]
fn every_figure_has_a_plot_a_verdict_numbers_and_data() {
    let html = html();
    let document = parsed(&html);
    for number in 5..=27 {
        let id = format!("figure-{number}");
        let mut sections = named(&document, "section");
        let section = sections
            .find(|node| node.attribute("id") == Some(&id))
            .unwrap();
        let has = |name: &str| section.descendants().any(|n| n.tag_name().name() == name);
        assert!(
            has("svg") && has("polyline") && has("figcaption") && has("table"),
            "{id}"
        );
        let mut inside = section.descendants();
        assert!(
            inside.any(|node| node.attribute("class") == Some("verdict")),
            "{id}"
        );
        assert!(
            report().join(format!("figure-{number:02}.csv")).is_file(),
            "{id}"
        );
    }
}

#[test]
fn page_needs_nothing_but_itself_and_its_links_lead_somewhere() {
    let html = html();
    let document = parsed(&html);
    let ids: Vec<&str> = document
        .descendants()
        .filter_map(|node| node.attribute("id"))
        .collect();
    let distinct: BTreeSet<&str> = ids.iter().copied().collect();
    assert_eq!(ids.len(), distinct.len(), "an id stands twice");
    for link in document
        .descendants()
        .filter_map(|node| node.attribute("href"))
    {
        match link.strip_prefix('#') {
            Some(id) => assert!(distinct.contains(id), "{link}"),
            None => assert!(report().join(link).is_file(), "{link}"),
        }
    }
    for node in document.descendants().filter(Node::is_element) {
        let name = node.tag_name().name();
        assert!(
            !["script", "link", "img", "iframe"].contains(&name),
            "{name}"
        );
        assert_eq!(node.attribute("src"), None, "{name}");
    }
    assert!(!html.contains("@import") && !html.contains("url("));
    // Larger pages open slowly; the figures take a third of this.
    assert!(html.len() < 3_000_000, "{} bytes", html.len());
}

#[test]
fn plots_have_no_gaps_and_stay_inside() {
    let html = html();
    let document = parsed(&html);
    for svg in named(&document, "svg") {
        let view: Vec<f64> = svg
            .attribute("viewBox")
            .unwrap()
            .split(' ')
            .map(|x| x.parse().unwrap())
            .collect();
        for line in svg
            .descendants()
            .filter_map(|node| node.attribute("points"))
        {
            for point in line.split_whitespace() {
                let (x, y) = point.split_once(',').unwrap();
                let (x, y): (f64, f64) = (x.parse().unwrap(), y.parse().unwrap());
                assert!(
                    (0.0..=view[2]).contains(&x) && (0.0..=view[3]).contains(&y),
                    "{point}"
                );
            }
        }
    }
}

#[test]
fn difference_curve_is_what_the_concrete_stepper_gives() {
    let parameters = Parameters::default();
    let start = Model::start(&parameters);
    let mut stepper = Stepper::<Increment>::new(parameters, start, 0.01).unwrap();
    let rows = rows("figure-09.csv", "Eq. 52", &["t", "θ", "ω"]);
    assert_eq!(rows.len(), 501);
    for row in &rows {
        while stepper.t() < row[0] - 0.005 {
            stepper.step().unwrap();
        }
        let state = stepper.state();
        let theta = state.Gamma[0].atan2(state.Gamma[1]);
        // The same operations in the same order.
        assert_eq!([stepper.t(), theta, state.omega], row[..]);
    }
}

#[test]
fn runge_kutta_curve_is_what_the_textbook_gives() {
    let (h, rate) = (0.1, -2.0 * 9.81 * 0.6 / 0.48);
    let f = |[angle, velocity]: [f64; 2]| [velocity, rate * angle.sin()];
    let ahead = |x: [f64; 2], k: [f64; 2], h: f64| [x[0] + h * k[0], x[1] + h * k[1]];
    let mut x = [0.0, 1.0];
    for row in rows("figure-05.csv", "Runge–Kutta 4", &["θ", "ω"]) {
        // Rounding of 500 steps; a wrong weight would show in the first digits.
        assert!((row[0] - x[0]).abs() < 1e-12 && (row[1] - x[1]).abs() < 1e-12);
        let k1 = f(x);
        let k2 = f(ahead(x, k1, h / 2.0));
        let k3 = f(ahead(x, k2, h / 2.0));
        let k4 = f(ahead(x, k3, h));
        let mean = [0, 1].map(|i| (k1[i] + 2.0 * k2[i] + 2.0 * k3[i] + k4[i]) / 6.0);
        x = ahead(x, mean, h);
    }
}

fn decimal(value: &Value) -> f64 {
    value.as_str().unwrap().parse().unwrap()
}

/// The last sample of a scene of the reference.
fn reference(kind: &str, scene: &str) -> Value {
    let text = include_str!(concat!(
        env!("CARGO_MANIFEST_DIR"),
        "/../../tests/data/reference.json"
    ));
    let all: Value = serde_json::from_str(text).unwrap();
    all[kind][scene]["samples"]
        .as_array()
        .unwrap()
        .last()
        .unwrap()
        .clone()
}

#[test]
fn exact_curves_end_at_the_reference() {
    // The rounding of t = 50 times ω, and of the scenes' decimals.
    const TOLERANCE: f64 = 1e-12;
    let end = reference("planar", "w0_1");
    let rows_ = rows("figure-12.csv", "exact for h = 0.01 s", &["t", "θ", "ω"]);
    let last = rows_.last().unwrap();
    assert!(
        (last[1] - decimal(&end["theta"])).abs() < TOLERANCE,
        "{last:?}"
    );
    assert!(
        (last[2] - decimal(&end["omega"])).abs() < TOLERANCE,
        "{last:?}"
    );

    // All rows of R, so the swing about a fixed axis is the motion.
    let end = reference("spatial", "paper");
    let files = [
        ("figure-23.csv", "Γ1"),
        ("figure-24.csv", "Γ2"),
        ("figure-25.csv", "Γ3"),
    ];
    for (i, (file, row)) in files.into_iter().enumerate() {
        let columns = ["x", "y", "z"].map(|axis| format!("{row}.{axis}"));
        let columns = columns.each_ref().map(String::as_str);
        let rows_ = rows(file, "exact for h = 0.1 s", &columns);
        for (j, value) in rows_.last().unwrap().iter().enumerate() {
            // Angular velocities near 9 rad/s over 100 s.
            assert!(
                (value - decimal(&end["R"][i][j])).abs() < 10.0 * TOLERANCE,
                "R.{i}{j}"
            );
        }
    }
}

#[test]
fn largest_differences_come_out_of_the_curves() {
    for curve in ["h = 0.05 s", "h = 0.01 s"] {
        let own = rows("figure-12.csv", curve, &["θ"]);
        let exact = rows("figure-12.csv", &format!("exact for {curve}"), &["θ"]);
        let differences = own
            .iter()
            .zip(&exact)
            .map(|(own, exact)| (own[0] - exact[0]).abs());
        let numbers = rows(
            "figure-12-numbers.csv",
            curve,
            &["off, last 5 s [rad]", "lag [s]"],
        );
        assert_eq!(differences.fold(0.0, f64::max), numbers[0][0]);
        // The midpoint rule turns a small oscillation of frequency Ω by 2 atan(Ωh/2) a step, so that it is
        // slower by (Ωh)²/12, and the amplitude of 0.2 rad changes that by amplitude²/8 at most.
        let h: f64 = curve[4..8].parse().unwrap();
        let omega_squared: f64 = 2.0 * 9.81 * 0.6 / 0.48;
        let expected = 50.0 * omega_squared * h * h / 12.0;
        assert!(
            (numbers[0][1] / expected - 1.0).abs() < 0.03,
            "{curve}: {numbers:?} {expected}"
        );
    }
}

#[test]
fn runge_kutta_damps_with_the_fifth_power_of_the_step() {
    let mut reader = csv::Reader::from_path(report().join("figure-05-steps.csv")).unwrap();
    let records: Vec<csv::StringRecord> = reader.records().map(Result::unwrap).collect();
    let number = |i: usize, column: usize| -> f64 { records[i][column].parse().unwrap() };
    let loss = |i: usize| -number(i, 1);
    // h = 0.01, 0.02, 0.05; the next term of the loss is of relative size (Ωh)²/8 < 0.01.
    let power = |i: usize, j: usize| (loss(i) / loss(j)).ln() / (number(i, 0) / number(j, 0)).ln();
    assert!((power(1, 0) - 5.0).abs() < 0.02 && (power(2, 1) - 5.0).abs() < 0.02);
}

#[test]
fn text_of_any_kind_stays_text() {
    let hostile = "<script>alert(\"1\")</script> & ' ]]> \u{1} ω";
    let mut data = Data::new(&[hostile, "n"]);
    data.row([Cell::Code(hostile.to_owned()), 1.5.into()]);
    data.row([format!("{hostile},\n\"").into(), Cell::Empty]);
    let table = Table {
        csv: "hostile".to_owned(),
        caption: hostile.to_owned(),
        data,
    };
    let page = Page {
        title: hostile.to_owned(),
        lead: hostile.to_owned(),
        sections: vec![Section {
            id: "a".to_owned(),
            title: hostile.to_owned(),
            blocks: vec![
                Block::Text(hostile.to_owned()),
                Block::List(vec![hostile.to_owned()]),
                Block::Facts(vec![(hostile.to_owned(), hostile.to_owned())]),
                Block::Table(table),
            ],
            parts: Vec::new(),
        }],
    };
    let folder = folder("hostile");
    page.write(&folder).unwrap();
    let html = fs::read_to_string(folder.join("index.html")).unwrap();
    let document = parsed(&html);
    assert_eq!(named(&document, "script").count(), 0);
    let heading = named(&document, "h2").next().unwrap();
    assert_eq!(
        heading.text(),
        Some(hostile.replace('\u{1}', "\u{FFFD}").as_str())
    );
    let mut reader = csv::Reader::from_path(folder.join("hostile.csv")).unwrap();
    let records: Vec<csv::StringRecord> = reader.records().map(Result::unwrap).collect();
    assert_eq!(&records[0], &csv::StringRecord::from(vec![hostile, "1.5"]));
    assert_eq!(&records[1][0], format!("{hostile},\n\""));
}

#[test]
fn folder_that_cannot_be_made_is_refused() {
    let file = folder("blocked").join("file");
    fs::write(&file, "").unwrap();
    let outcome = residua(&format!("report --out {}", file.display()));
    assert_refused(&outcome, 1, &["cannot write", "file"]);
}
