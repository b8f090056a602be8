//! The language in one page, written from the table that the calls are bound by.

use core::fmt::Write as _;

use assemcad_model::language::{Default, Method, Type, method, methods};
use assemcad_model::ports::ALL;

use crate::language::bind::signature;
use crate::language::call::params;
use crate::language::cq::OWN;

/// What a factory is.
const FACTORY: &str = r#"# The factory language
CadQuery's `Workplane` in Starlark, a Python without imports of its own. A script records calls; the
solid is made afterwards, so that nothing can be asked of it (no .val().Center(), .size(), .Volume()).
Lengths in mm, angles in degrees. `cq` and `math` are there; `import cadquery as cq` does nothing.
A factory:
    factory(doc = """What it makes, its frame, its ports.""", params = {
        "length": number(80, 10, 500, doc = "along x"),       # default, min, max; unit = "mm"|"deg"|"N"|""
        "holes": integer(4, 2, 12, doc = "how many"),
        "style": choice("round", ["round", "square"]),
        "hub": flag(True),
        "steps": records(fields = {"d": number(20, 1, 200)}, default = [{"d": 20}], min_items = 1, max_items = 9),
    })
    def build(p):
        require(p.length > 20, "length %s leaves no room for the holes" % p.length)
        plate = cq.Workplane("XY").box(p.length, 40, 8, centered=(True, True, False))
        plate = plate.faces(">Z").workplane().rarray(p.length / p.holes, 1, p.holes, 1).bore_port("hole", 5)
        return plate.faces("<Z").workplane().face_port("bottom")
`require(condition, message)` states a rule between parameters, `fail(message)` refuses them.
`def designation(p)` may return what a standard calls the part ("ISO 4032 - M8"), for the bill of
materials, or None; of a factory that is not built in it is not taken up. A plain
script has neither factory nor build and leaves its part in `result`. Chains keep their pending wires and
tags as in CadQuery. + | unite, - cuts, * & intersect, / splits.
"#;

const WORKPLANE: &str = r#"
## Workplane
Everything with a default is best given by name. Not repeated below: `forConstruction=False` of what draws,
`clean=True`, `tol=None`, `tag=None` of what selects, and `combine=True` of what makes solids (True or "a"
joins the chain's solid, "s" or "cut" cuts it, False stands alone).
"#;

const PORTS: &str = "
## Methods that make geometry and its port in one
At every point of the stack, z of the plane out of the material. Several points give NAME_1, NAME_2 and
so on; `center` names a port in their middle, `back` one at a hole's far mouth.
";

const SELECTORS: &str = r#"
## Selectors
`>Z` `<Z` the outermost by centre, `>Z[1]` `<Z[-2]` the n-th among parallel ones, `>>Z[1]` by centre among
all; `|Z` parallel, `#Z` square to it, `+Z` `-Z` along, `%PLANE` `%CIRCLE` by form. Directions X, Y, Z, XY,
XZ, YZ, (1,0,1). `and`, `or`, `exc`, `not`, brackets. Objects are joined by + - * and unary -; all are in
`cq` and in `cq.selectors`:
"#;

const LACKS: &str = r#"
## What of Python is not there
while (for i in range(1000) with break), try, class, with, `**` (pow), `is` (==), chained comparisons,
`*=`, isinstance (type(x) == "list"), map, filter, sets, "".join / .format / .replace and list.extend
(join(", ", items), "%s" % x or f"{x:.2f}", replace(text, old, new), items += more). print goes nowhere.
There are def, lambda, comprehensions, dict, str, len, range, zip, enumerate, sorted, reversed, min, max,
abs, any, all, int, float, sum, round, pow, divmod, and of math: "#;

/// The language in one page: every function with its parameters and defaults, from the table that the
/// calls are bound by, and what there is to know besides.
#[must_use]
pub fn reference() -> String {
    let mut page = String::from(FACTORY);
    page.push_str(WORKPLANE);
    let on = |kind: Type| methods().filter(move |m| m.on == Some(kind) && m.name.contains('.'));
    let (ports, others): (Vec<_>, Vec<_>) =
        on(Type::Workplane).partition(|m| m.name.contains("port"));
    list(&mut page, method("Workplane").into_iter().chain(others));
    page.push_str(PORTS);
    list(&mut page, ports.into_iter());
    let types: Vec<String> = ALL
        .iter()
        .map(|kind| {
            let names: Vec<String> = kind
                .params
                .iter()
                .map(|p| match p.optional {
                    Some(default) => format!("{}={default}", p.name),
                    None => p.name.to_owned(),
                })
                .collect();
            format!("{}({})", kind.name, names.join(", "))
        })
        .collect();
    let _ = writeln!(
        page,
        "Types of ports and their params: {}.",
        types.join(", ")
    );
    page.push_str("\n## Shapes (from .val(), or made directly)\n");
    let made = methods().filter(|m| m.on.is_none() && m.name.contains('.'));
    list(&mut page, on(Type::Shape).chain(made));
    page.push_str("\n## Values\n");
    page.push_str(
        "cq.Vector(x, y, z): .x .y .z .Length add sub multiply cross dot normalized toTuple, + - *\n\
         cq.Location(x, y, z, rx, ry, rz), (vector, angles), (vector, axis, angle), (plane): * .inverse\n",
    );
    for (name, params) in OWN
        .iter()
        .filter(|(n, p)| !n.contains("Sel") && !p.is_empty())
    {
        let _ = writeln!(page, "cq.{}", signature(name, params.iter()));
    }
    page.push_str(SELECTORS);
    let selectors: Vec<String> = OWN
        .iter()
        .filter_map(|(name, params)| {
            Some(signature(name.strip_prefix("selectors.")?, params.iter()))
        })
        .collect();
    let _ = writeln!(page, "{}", selectors.join(", "));
    page.push_str(LACKS);
    page.push_str(&crate::language::math_names().join(", "));
    page.push('\n');
    page
}

/// Parameters that many methods have, each with the default that goes without saying.
const COMMON: [(&str, Default); 5] = [
    ("clean", Default::Flag(true)),
    ("combine", Default::Flag(true)),
    ("forConstruction", Default::Flag(false)),
    ("tag", Default::None),
    ("tol", Default::None),
];

/// Shorter lines of documentation say no more than the name does.
const SHORTEST_DOC: usize = 34;

/// Writes methods; those that need no word stand together at the end.
fn list<'a>(page: &mut String, methods: impl Iterator<Item = &'a Method>) {
    let mut plain = Vec::new();
    for method in methods {
        let name = match method.on {
            Some(_) => format!(".{}", method.short()),
            None => format!("cq.{}", method.name),
        };
        let params = params(method)
            .iter()
            .filter(|p| !COMMON.contains(&(p.name, p.default)));
        let called = signature(&name, params);
        let gives = match (method.on, method.gives) {
            (Some(Type::Workplane), Type::Shape) => " -> shape",
            (Some(Type::Workplane), Type::Shapes) => " -> shapes",
            _ => "",
        };
        if method.doc.len() < SHORTEST_DOC {
            plain.push(format!("{called}{gives}"));
        } else {
            let _ = writeln!(page, "{called}{gives}: {}", method.doc);
        }
    }
    if !plain.is_empty() {
        let _ = writeln!(page, "And {}", plain.join(", "));
    }
}

#[cfg(test)]
mod tests {
    use assemcad_model::language::methods;

    #[test]
    fn the_page_names_every_method_and_is_short() {
        let page = super::reference();
        assert_eq!(page, super::reference());
        for method in methods().filter(|m| !m.name.starts_with("each")) {
            assert!(
                page.contains(&format!("{}(", method.short())),
                "{}",
                method.name
            );
        }
        assert!(page.len() < 13_500, "{}", page.len());
    }

    #[test]
    fn the_factory_of_the_page_can_be_built() {
        let example: String = super::FACTORY
            .lines()
            .filter_map(|l| l.strip_prefix("    "))
            .map(|l| format!("{l}\n"))
            .collect();
        let factory = crate::Factory::parse("page.example", &example).unwrap();
        let built = factory.build(&serde_json::Map::new()).unwrap();
        assert_eq!(
            built.recipe.calls.last().unwrap().call,
            "Workplane.face_port"
        );
    }
}
