//! `cq`: the functions of the table that are called on nothing, and the values that need no kernel.

use std::collections::BTreeMap;
use std::sync::LazyLock;

use assemcad_model::language::{Default, Kind, Method, Param, methods};
use assemcad_model::selector::{FORMS, Key, Selector as Choice};
use serde_json::Value as Json;
use starlark::eval::{Arguments, Evaluator};
use starlark::values::{Heap, Value};

use super::bind::Given;
use super::session::{Session, line};
use super::{convert, ports, pure};
use crate::fault::Fault;
use crate::values::{Function, Item, Outline, Plane, Selector, native};

const fn param(name: &'static str, kind: Kind, default: Default) -> Param {
    Param {
        name,
        kind,
        default,
    }
}

const VECTOR: Param = param("vector", Kind::Vector, Default::Required);
const N: Param = param("n", Kind::Count, Default::Required);
const UPWARDS: Param = param("directionMax", Kind::Flag, Default::Flag(true));
const ORIGIN: Param = param("origin", Kind::Vector, Default::Vector([0.0; 3]));
const X_DIR: Param = param("xDir", Kind::Vector, Default::None);

/// What `cq` has beside the functions of the table, and what each takes; sorted.
pub(crate) static OWN: &[(&str, &[Param])] = &[
    ("Location", &[]),
    (
        "Plane",
        &[
            ORIGIN,
            X_DIR,
            param("normal", Kind::Vector, Default::Vector([0.0, 0.0, 1.0])),
        ],
    ),
    (
        "Plane.named",
        &[
            param("stdName", Kind::Choice(&convert::PLANES), Default::Required),
            ORIGIN,
        ],
    ),
    ("Vector", &[]),
    (
        "involute",
        &[
            param("module", Kind::Real, Default::Required),
            param("teeth", Kind::Count, Default::Required),
            param("pressure_angle_deg", Kind::Real, Default::Real(20.0)),
            param("profile_shift", Kind::Real, Default::Real(0.0)),
            param("thinning", Kind::Real, Default::Real(0.0)),
        ],
    ),
    ("selectors.AreaNthSelector", &[N, UPWARDS]),
    (
        "selectors.BoxSelector",
        &[
            param("point0", Kind::Vector, Default::Required),
            param("point1", Kind::Vector, Default::Required),
            param("boundingbox", Kind::Flag, Default::Flag(false)),
        ],
    ),
    ("selectors.CenterNthSelector", &[VECTOR, N, UPWARDS]),
    ("selectors.DirectionMinMaxSelector", &[VECTOR, UPWARDS]),
    ("selectors.DirectionNthSelector", &[VECTOR, N, UPWARDS]),
    ("selectors.DirectionSelector", &[VECTOR]),
    ("selectors.LengthNthSelector", &[N, UPWARDS]),
    (
        "selectors.NearestToPointSelector",
        &[param("pnt", Kind::Vector, Default::Required)],
    ),
    ("selectors.ParallelDirSelector", &[VECTOR]),
    ("selectors.PerpendicularDirSelector", &[VECTOR]),
    ("selectors.RadiusNthSelector", &[N, UPWARDS]),
    (
        "selectors.StringSyntaxSelector",
        &[param("selectorString", Kind::Selector, Default::Required)],
    ),
    (
        "selectors.TypeSelector",
        &[param("typeString", Kind::Text, Default::Required)],
    ),
];

/// What a name behind `cq.` stands for.
#[derive(Clone, Copy)]
enum Target {
    /// Only something to write a point after.
    Group,
    /// A function of the table.
    Method(&'static Method),
    /// A value of the front end.
    Own(&'static [Param]),
    /// `Plane.XY` and the like, with the parameters of all of them.
    Named(&'static str),
    /// `exporters.export`.
    Export,
}

static TARGETS: LazyLock<BTreeMap<String, Target>> = LazyLock::new(|| {
    let mut all = BTreeMap::new();
    for method in methods().filter(|m| m.on.is_none()) {
        if let Some((class, _)) = method.name.split_once('.') {
            all.entry(class.to_owned()).or_insert(Target::Group);
        }
        all.insert(method.name.to_owned(), Target::Method(method));
    }
    all.insert("selectors".to_owned(), Target::Group);
    all.insert("exporters".to_owned(), Target::Group);
    all.insert("exporters.export".to_owned(), Target::Export);
    for (path, params) in OWN {
        all.insert((*path).to_owned(), Target::Own(params));
        // CadQuery has most selectors under both names; here all are.
        if let Some(short) = path.strip_prefix("selectors.") {
            all.insert(short.to_owned(), Target::Own(params));
        }
    }
    for name in convert::PLANES {
        all.insert(format!("Plane.{name}"), Target::Named(name));
    }
    all
});

/// The names directly behind `cq.PATH.`.
pub(crate) fn members(path: &str) -> impl Iterator<Item = &'static str> {
    let path = path.to_owned();
    TARGETS.keys().filter_map(move |key| {
        let short = if path.is_empty() {
            key.as_str()
        } else {
            key.strip_prefix(&path)?.strip_prefix('.')?
        };
        (!short.contains('.')).then_some(short)
    })
}

/// Whether there is something behind `cq.`.
pub(crate) fn has(path: &str) -> bool {
    TARGETS.contains_key(path)
}

/// What `cq.PATH.NAME` is.
pub(crate) fn attribute<'v>(path: &str, name: &str, heap: Heap<'v>) -> Option<Value<'v>> {
    let full = if path.is_empty() {
        name.to_owned()
    } else {
        format!("{path}.{name}")
    };
    let (path, target) = TARGETS.get_key_value(&full)?;
    Some(match target {
        Target::Method(method) => heap.alloc(Function { method, on: None }),
        _ => heap.alloc(Item { path }),
    })
}

/// Calls what is behind `cq.`.
pub(crate) fn invoke<'v>(
    path: &'static str,
    args: &Arguments<'v, '_>,
    eval: &mut Evaluator<'v, '_, '_>,
) -> starlark::Result<Value<'v>> {
    let line = line(eval);
    let given = Given::of(args, eval.heap())?;
    make(path, &given, eval).map_err(|fault| native(fault.line(line)))
}

fn make<'v>(
    path: &'static str,
    given: &Given<'v>,
    eval: &mut Evaluator<'v, '_, '_>,
) -> Result<Value<'v>, Fault> {
    let heap = eval.heap();
    let short = path.rsplit('.').next().unwrap_or(path);
    let params = match TARGETS.get(path) {
        Some(Target::Own(params)) => params,
        Some(Target::Named(name)) => {
            static PARAMS: &[Param] = &[ORIGIN, X_DIR];
            let args = arguments(name, PARAMS, given)?;
            let named = pure::named(name, args.vector("origin"));
            let x = args.maybe("xDir").unwrap_or(named.frame.x);
            return Plane::new(named.frame.origin, Some(x), named.frame.z).map(|p| heap.alloc(p));
        }
        Some(Target::Export) => {
            return Err(Fault::new("a script writes no files")
                .hint("leave the solid in `result`: the program that runs the script exports it"));
        }
        _ => {
            return Err(Fault::new(format!(
                "cq.{path} is nothing that can be called"
            )));
        }
    };
    match short {
        "Vector" => return pure::point(given).map(|v| heap.alloc(v)),
        "Location" => return pure::location(given).map(|l| heap.alloc(l)),
        _ => {}
    }
    let args = arguments(short, params, given)?;
    Ok(match short {
        "Plane" => heap.alloc(Plane::new(
            args.vector("origin"),
            args.maybe("xDir"),
            args.vector("normal"),
        )?),
        "named" => heap.alloc(pure::named(&args.text("stdName"), args.vector("origin"))),
        "involute" => {
            let outline = ports::toothing(&args.0)?.outline().map_err(Fault::new)?;
            let session = Session::of(eval)?;
            session.recorder.get().charge(outline.segments.len() + 1)?;
            heap.alloc(Outline { outline })
        }
        _ => heap.alloc(Selector::new(selector(short, &args)?)),
    })
}

struct Args(BTreeMap<String, Json>);

fn arguments(name: &str, params: &'static [Param], given: &Given<'_>) -> Result<Args, Fault> {
    let mut args = BTreeMap::new();
    for (param, value) in params.iter().zip(given.bind(name, params)?) {
        let value = value.filter(|v| !(v.is_none() && param.default == Default::None));
        let written = match value {
            Some(value) => Some(convert::write(param.kind, value, param.name)?),
            None => convert::default(param),
        };
        args.extend(written.map(|written| (param.name.to_owned(), written)));
    }
    Ok(Args(args))
}

impl Args {
    fn maybe(&self, name: &str) -> Option<[f64; 3]> {
        let numbers = self.0.get(name)?.as_array()?;
        let numbers: Option<Vec<f64>> = numbers.iter().map(Json::as_f64).collect();
        numbers?.try_into().ok()
    }

    fn vector(&self, name: &str) -> [f64; 3] {
        self.maybe(name).unwrap_or_default()
    }

    fn text(&self, name: &str) -> String {
        let text = self.0.get(name).and_then(Json::as_str);
        text.unwrap_or_default().to_owned()
    }

    fn flag(&self, name: &str) -> bool {
        self.0.get(name).and_then(Json::as_bool).unwrap_or_default()
    }
}

fn selector(name: &str, args: &Args) -> Result<Choice, Fault> {
    let along = args.vector("vector");
    if args.0.contains_key("vector") && along == [0.0; 3] {
        return Err(Fault::new("vector has a length, not (0, 0, 0)"));
    }
    let nth = |key: Key, index: Option<i32>| Choice::Nth {
        key,
        index: index.unwrap_or(-1),
        ascending: args.flag("directionMax"),
    };
    let n = args
        .0
        .get("n")
        .and_then(Json::as_i64)
        .and_then(|n| i32::try_from(n).ok());
    Ok(match name {
        "BoxSelector" => Choice::Box {
            from: args.vector("point0"),
            to: args.vector("point1"),
            whole: args.flag("boundingbox"),
        },
        "NearestToPointSelector" => Choice::Nearest(args.vector("pnt")),
        "ParallelDirSelector" => Choice::Parallel(along),
        "DirectionSelector" => Choice::Along(along),
        "PerpendicularDirSelector" => Choice::Perpendicular(along),
        "TypeSelector" => {
            let form = args.text("typeString").to_ascii_uppercase();
            if !FORMS.contains(&form.as_str()) && form != "OTHER" {
                return Err(Fault::new(format!(
                    "typeString is one of {} or OTHER",
                    FORMS.join(", ")
                )));
            }
            Choice::Form(form)
        }
        "DirectionMinMaxSelector" | "CenterNthSelector" => nth(Key::Center(along), n),
        "DirectionNthSelector" => nth(Key::ParallelCenter(along), n),
        "RadiusNthSelector" => nth(Key::Radius, n),
        "LengthNthSelector" => nth(Key::Length, n),
        "AreaNthSelector" => nth(Key::Area, n),
        // Written out by the conversion of its argument.
        _ => {
            let written = args.0.get("selectorString").cloned().unwrap_or_default();
            serde_json::from_value(written).map_err(|e| Fault::new(e.to_string()))?
        }
    })
}
