//! The HTML of a page: one file, well-formed as XML, with its style inside and no scripts.

use super::page::Block;
use super::page::Cell;
use super::page::Data;
use super::page::Diagram;
use super::page::Figure;
use super::page::Judgement;
use super::page::Page;
use super::page::Section;
use super::page::Table;
use super::page::Verdict;
use crate::plot;
use std::fmt::Write as _;

/// The page as text.
pub fn html(page: &Page) -> Result<String, String> {
    let mut sections = String::new();
    for section in &page.sections {
        sections += &self::section(section, 2)?;
    }
    let title = escaped(&page.title);
    let lead = escaped(&page.lead);
    let contents = contents(&page.sections);
    let style = concat!("\n", include_str!("style.css"));
    let recolouring = plot::recolouring();
    Ok(format!(
        r#"<!DOCTYPE html>
<html lang="en" xmlns="http://www.w3.org/1999/xhtml">
<head>
<meta charset="utf-8"/>
<meta name="viewport" content="width=device-width, initial-scale=1"/>
<meta name="color-scheme" content="light dark"/>
<title>{title}</title>
<style>{style}{recolouring}</style>
</head>
<body>
<header>
<h1>{title}</h1>
<p class="lead">{lead}</p>
</header>
{contents}<main>
{sections}</main>
</body>
</html>
"#
    ))
}

/// Text without the characters that mean something in HTML.
fn escaped(text: &str) -> String {
    let mut safe = String::with_capacity(text.len());
    for c in text.chars() {
        match c {
            '&' => safe.push_str("&amp;"),
            '<' => safe.push_str("&lt;"),
            '>' => safe.push_str("&gt;"),
            '"' => safe.push_str("&quot;"),
            // XML has no place for other control characters.
            c if c.is_control() && !c.is_whitespace() => safe.push('\u{FFFD}'),
            other => safe.push(other),
        }
    }
    safe
}

fn contents(sections: &[Section]) -> String {
    let entry = |section: &Section| {
        let (id, title) = (escaped(&section.id), escaped(&section.title));
        format!(r##"<a href="#{id}">{title}</a>"##)
    };
    let mut list = String::from("<nav aria-label=\"Contents\">\n<ul>\n");
    for section in sections {
        let _ = write!(list, "<li>{}", entry(section));
        if !section.parts.is_empty() {
            let parts = section.parts.iter().map(entry);
            let parts: String = parts.map(|part| format!("<li>{part}</li>\n")).collect();
            let _ = write!(list, "\n<ul>\n{parts}</ul>\n");
        }
        list += "</li>\n";
    }
    list + "</ul>\n</nav>\n"
}

fn section(section: &Section, level: usize) -> Result<String, String> {
    let (id, title) = (escaped(&section.id), escaped(&section.title));
    let mut text = format!("<section id=\"{id}\">\n<h{level}>{title}</h{level}>\n");
    for block in &section.blocks {
        text += &self::block(block)?;
    }
    for part in &section.parts {
        text += &self::section(part, level + 1)?;
    }
    Ok(text + "</section>\n")
}

fn block(block: &Block) -> Result<String, String> {
    Ok(match block {
        Block::Text(text) => format!("<p>{}</p>\n", escaped(text)),
        Block::List(points) => list(points),
        Block::Code(code) => format!("<pre><code>{}</code></pre>\n", escaped(code)),
        Block::Facts(facts) => self::facts(facts),
        Block::Figure(figure) => self::figure(figure)?,
        Block::Diagram(diagram) => self::diagram(diagram)?,
        Block::Table(table) => self::table(table),
        Block::Folded(table) => {
            let (rows, table) = (table.data.rows.len(), self::table(table));
            format!("<details>\n<summary>{rows} rows</summary>\n{table}</details>\n")
        }
        Block::Verdict(verdict) => self::verdict(verdict),
    })
}

fn list(points: &[String]) -> String {
    let point = |point: &String| format!("<li>{}</li>\n", escaped(point));
    format!(
        "<ul>\n{}</ul>\n",
        points.iter().map(point).collect::<String>()
    )
}

fn facts(facts: &[(String, String)]) -> String {
    let fact = |(term, meaning): &(String, String)| {
        let (term, meaning) = (escaped(term), escaped(meaning));
        format!("<dt>{term}</dt><dd>{meaning}</dd>\n")
    };
    format!(
        "<dl>\n{}</dl>\n",
        facts.iter().map(fact).collect::<String>()
    )
}

fn figure(figure: &Figure) -> Result<String, String> {
    let class = if figure.overlay {
        "plot overlay"
    } else {
        "plot"
    };
    let svg = plot::svg(&figure.plot)?;
    Ok(picture(class, &svg, &figure.caption, &figure.csv))
}

fn diagram(diagram: &Diagram) -> Result<String, String> {
    let svg = plot::logarithmic_svg(&diagram.plot)?;
    Ok(picture("plot", &svg, &diagram.caption, &diagram.csv))
}

fn picture(class: &str, svg: &str, caption: &str, csv: &str) -> String {
    let (caption, csv) = (escaped(caption), csv_link(csv));
    format!(
        "<figure>\n<div class=\"{class}\" role=\"img\" aria-label=\"{caption}\">\n{svg}</div>\n\
         <figcaption>{caption} {csv}</figcaption>\n</figure>\n"
    )
}

fn table(table: &Table) -> String {
    let Data { head, rows } = &table.data;
    let numeric: Vec<bool> = (0..head.len())
        .map(|column| is_numeric(rows, column))
        .collect();
    let class = |column: usize| match numeric.get(column) {
        Some(true) => " class=\"number\"",
        _ => "",
    };
    let mut text = String::from("<figure class=\"table\">\n");
    let (caption, csv) = (escaped(&table.caption), csv_link(&table.csv));
    let _ = writeln!(
        text,
        "<figcaption>{caption} {csv}</figcaption>\n<div class=\"scroll\"><table>\n<thead><tr>"
    );
    for (column, name) in head.iter().enumerate() {
        let (class, name) = (class(column), escaped(name));
        let _ = writeln!(text, "<th scope=\"col\"{class}>{name}</th>");
    }
    text += "</tr></thead>\n<tbody>\n";
    for row in rows {
        text += "<tr>";
        for (column, cell) in row.iter().enumerate() {
            let _ = write!(text, "<td{}>{}</td>", class(column), self::cell(cell));
        }
        text += "</tr>\n";
    }
    text + "</tbody>\n</table></div>\n</figure>\n"
}

/// There is a number in the column, and nothing else.
fn is_numeric(rows: &[Vec<Cell>], column: usize) -> bool {
    let mut cells = rows
        .iter()
        .filter_map(|row| row.get(column))
        .filter(|cell| **cell != Cell::Empty)
        .peekable();
    cells.peek().is_some() && cells.all(Cell::is_number)
}

fn cell(cell: &Cell) -> String {
    let shown = escaped(&cell.shown());
    match cell {
        Cell::Code(_) => format!("<code>{shown}</code>"),
        Cell::Judgement(judgement) => badge(*judgement),
        _ => shown,
    }
}

fn badge(judgement: Judgement) -> String {
    let class = match judgement {
        Judgement::Holds => "holds",
        Judgement::DoesNotHold => "fails",
        Judgement::HoldsWhen => "when",
    };
    format!("<span class=\"badge {class}\">{}</span>", judgement.words())
}

fn verdict(verdict: &Verdict) -> String {
    let badge = badge(verdict.judgement);
    let (statement, reason) = (escaped(&verdict.statement), escaped(&verdict.reason));
    format!(
        "<div class=\"verdict\">\n<p class=\"statement\">{statement}</p>\n<p>{badge} {reason}</p>\n</div>\n"
    )
}

fn csv_link(stem: &str) -> String {
    let stem = escaped(stem);
    format!("<a class=\"data\" href=\"{stem}.csv\">{stem}.csv</a>")
}
