//! How names, units and numbers are printed.

use residua::description::{Description, Variable};

/// The components of a variable: `ω`, `Γ.x`, `q.4`, `R.12`.
pub fn components(variable: &Variable) -> Vec<String> {
    let name = variable.name;
    match (variable.rows, variable.cols) {
        (1, 1) => vec![name.to_owned()],
        (rows @ ..=3, 1) => ["x", "y", "z"][..rows]
            .iter()
            .map(|axis| format!("{name}.{axis}"))
            .collect(),
        (rows, 1) => (1..=rows).map(|row| format!("{name}.{row}")).collect(),
        (rows, cols) => {
            // One digit each reads as in the mathematics; beyond nine a separator is needed.
            let between = if rows > 9 || cols > 9 { "_" } else { "" };
            (1..=rows)
                .flat_map(|row| (1..=cols).map(move |col| (row, col)))
                .map(|(row, col)| format!("{name}.{row}{between}{col}"))
                .collect()
        }
    }
}

/// Units as they are printed: `kg·m²/s` for `kg*m^2/s`.
pub fn unit(symbols: &str) -> String {
    let mut printed = String::new();
    let mut rest = symbols.chars().peekable();
    while let Some(c) = rest.next() {
        match c {
            '*' => printed.push('·'),
            '^' if rest.peek().is_some_and(|&next| is_exponent(next)) => {
                while let Some(digit) = rest.next_if(|&next| is_exponent(next)) {
                    printed.push(superscript(digit));
                }
            }
            other => printed.push(other),
        }
    }
    printed
}

/// Whether a model gives any unit; without one, time is a mere number.
pub fn has_units(description: &Description) -> bool {
    let outputs = description.outputs.iter().map(|output| &output.variable);
    let variables = description
        .parameters
        .iter()
        .chain(description.states)
        .chain(outputs);
    variables
        .into_iter()
        .any(|variable| !variable.dimensionless)
}

/// 10ⁿ
pub fn power_of_ten(exponent: i32) -> String {
    format!(
        "10{}",
        exponent
            .to_string()
            .chars()
            .map(superscript)
            .collect::<String>()
    )
}

fn is_exponent(c: char) -> bool {
    c.is_ascii_digit() || c == '-'
}

fn superscript(c: char) -> char {
    match c {
        '-' => '⁻',
        '1' => '¹',
        '2' => '²',
        '3' => '³',
        digit => digit
            .to_digit(10)
            .and_then(|value| char::from_u32(0x2070 + value))
            .unwrap_or(digit),
    }
}

/// A value as the language writes it: `0.48`, `[0, 0, 0.7]`, `[[1, 0], [0, 1]]`.
pub fn value(components: &[f64], (_, cols): (usize, usize)) -> String {
    let list = |values: &[f64]| {
        let numbers: Vec<String> = values.iter().map(|&value| number(value)).collect();
        format!("[{}]", numbers.join(", "))
    };
    match (components, cols) {
        (&[scalar], _) => number(scalar),
        (vector, 0 | 1) => list(vector),
        (matrix, cols) => {
            let rows: Vec<String> = matrix.chunks(cols).map(list).collect();
            format!("[{}]", rows.join(", "))
        }
    }
}

/// Six significant digits at most, without trailing zeros.
pub fn number(value: f64) -> String {
    let size = value.abs();
    if size != 0.0 && !(1e-4..1e7).contains(&size) {
        return format!("{value:.3e}");
    }
    let before_point = if size < 1.0 {
        1
    } else {
        size.log10() as usize + 1
    };
    let text = format!("{value:.*}", 7 - before_point.min(7));
    match text.contains('.') {
        true => text.trim_end_matches('0').trim_end_matches('.').to_owned(),
        false => text,
    }
}

/// All digits of a number, by powers of ten where it is far from 1.
pub fn exact(value: f64) -> String {
    if value == 0.0 || (1e-5..1e17).contains(&value.abs()) {
        format!("{value}")
    } else {
        format!("{value:e}")
    }
}

/// Characters of input that a message repeats.
const REPEATED: usize = 80;

/// The begin of a long text, or a short one as it is.
pub fn excerpt(text: &str) -> String {
    match text.char_indices().nth(REPEATED) {
        Some((end, _)) => format!("{}…", &text[..end]),
        None => text.to_owned(),
    }
}

/// A value for reading, to some significant digits: `0.0102`, `1.2·10⁻¹³`, `−25`.
pub fn rounded(value: f64, digits: usize) -> String {
    if !value.is_finite() {
        return "–".to_owned();
    }
    let precision = digits.saturating_sub(1);
    let scientific = format!("{value:.precision$e}");
    let (mantissa, exponent) = scientific.split_once('e').unwrap_or((&scientific, "0"));
    let exponent: i32 = exponent.parse().unwrap_or(0);
    let text = match exponent {
        -4..=5 => {
            let decimals = usize::try_from(precision as i32 - exponent).unwrap_or(0);
            format!("{value:.decimals$}")
        }
        _ => format!("{mantissa}·{}", power_of_ten(exponent)),
    };
    text.replace('-', "−")
}

#[cfg(test)]
mod tests;
