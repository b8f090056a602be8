//! Imports: what binds names that are there already, and what is refused.

use crate::fault::Fault;
use crate::language::cq;
use crate::scan::RESERVED_PREFIX;

/// Where an import ends: at the end of its line, or behind the bracket that it opens.
pub(crate) fn end_of_import(source: &str, from: usize) -> usize {
    let rest = source.get(from..).unwrap_or_default();
    let line = rest.find(['\n', ';', '#']).unwrap_or(rest.len());
    let first = rest.get(..line).unwrap_or_default();
    let length = match (first.contains('('), rest.find(')')) {
        (true, Some(end)) => end + 1,
        _ => line,
    };
    from + length
}

/// What an import does here: it binds names that are there already, or nothing.
pub(crate) fn import(text: &str) -> Result<String, Fault> {
    // Comments stand within brackets.
    let plain: String = text
        .lines()
        .map(|line| line.split('#').next().unwrap_or_default())
        .collect::<Vec<_>>()
        .join(" ")
        .replace(['(', ')', '\\'], " ");
    let mut bound = Vec::new();
    if let Some(rest) = plain.trim().strip_prefix("from ") {
        let (module, names) = rest
            .split_once(" import ")
            .ok_or_else(|| Fault::new("this import names nothing"))?;
        let module = module.trim();
        if module == "__future__" {
            return Ok("pass".to_owned());
        }
        let base = base(module)?;
        for (name, alias) in names.split(',').filter_map(pair) {
            if name == "*" {
                let all = members(base).into_iter();
                bound.extend(all.map(|name| format!("{name} = {base}.{name}")));
                continue;
            }
            if !members(base).contains(&name) {
                return Err(Fault::new(format!("{module} has no '{name}' here"))
                    .hint(format!("there are: {}", members(base).join(", "))));
            }
            bound.push(format!(
                "{} = {base}.{name}",
                alias_of(alias.unwrap_or(name))?
            ));
        }
    } else {
        let names = plain.trim().trim_start_matches("import");
        for (name, alias) in names.split(',').filter_map(pair) {
            let base = base(name)?;
            match alias {
                Some(alias) if alias != base => {
                    bound.push(format!("{} = {base}", alias_of(alias)?))
                }
                _ => {}
            }
        }
    }
    Ok(if bound.is_empty() {
        "pass".to_owned()
    } else {
        bound.join("; ")
    })
}

fn pair(text: &str) -> Option<(&str, Option<&str>)> {
    let mut words = text.split_whitespace();
    let name = words.next()?;
    match (words.next(), words.next()) {
        (Some("as"), Some(alias)) => Some((name, Some(alias))),
        _ => Some((name, None)),
    }
}

fn alias_of(alias: &str) -> Result<&str, Fault> {
    let plain = alias.chars().all(|c| c.is_ascii_alphanumeric() || c == '_')
        && !alias.starts_with(|c: char| c.is_ascii_digit())
        && !alias.starts_with(RESERVED_PREFIX);
    plain
        .then_some(alias)
        .ok_or_else(|| Fault::new("this import gives a name that cannot be one"))
}

/// What stands for a module.
fn base(module: &str) -> Result<&'static str, Fault> {
    let hint = match module {
        "cadquery" | "cq" | "cadquery.cq" => return Ok("cq"),
        "cadquery.selectors" => return Ok("cq.selectors"),
        "cadquery.exporters" => return Ok("cq.exporters"),
        "math" => return Ok("math"),
        "typing" => "types may be written and mean nothing: leave the import out",
        "numpy" | "np" => "write lists, `for`, and math.sin(x) and so on",
        "random" | "time" | "datetime" => {
            "the same script gives the same part, always: write the values out"
        }
        "os" | "sys" | "pathlib" | "json" | "io" => "a script reaches nothing outside itself",
        _ => "only cadquery and math can be imported, and both are there already",
    };
    let shown = assemcad_model::param::clip(module);
    Err(Fault::new(format!("there is no module '{shown}'")).hint(hint))
}

fn members(base: &str) -> Vec<&'static str> {
    match base.strip_prefix("cq") {
        Some(path) => cq::members(path.trim_start_matches('.')).collect(),
        None => crate::language::math_names(),
    }
}
