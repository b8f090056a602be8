//! Specifications and their texts: what is written is what is read, and the other way round.
#![cfg(test)]

use assemcad_model::mates::ALL;
use assemcad_model::spec::tree::Tree;
use assemcad_model::spec::{Accepted, Assembly, End, Mate, Part, PartMotion, WorldAxis, text};
use assemcad_store::Draft;
use proptest::prelude::*;
use serde_json::{Map, Value, json};

fn any_text() -> impl Strategy<Value = String> {
    prop_oneof![
        "[A-Za-z0-9_-]{1,12}",
        any::<String>(),
        prop::sample::select(vec![
            "on",
            "1e3",
            "null",
            "",
            "007",
            "true",
            "a: b",
            "# x",
            "x # y",
            "- a",
            "*a",
            "\n\n",
            " lead",
            "trail ",
            "\u{2028}",
            "\u{feff}x",
            "---",
            "[",
            "{}",
            "'",
            "\\",
            "%a",
            "1.50",
        ])
        .prop_map(str::to_owned),
    ]
}

fn any_value() -> impl Strategy<Value = Value> {
    let leaf = prop_oneof![
        any::<bool>().prop_map(|b| json!(b)),
        any::<i64>().prop_map(|n| json!(n)),
        any::<u64>().prop_map(|n| json!(n)),
        prop::num::f64::ANY
            .prop_filter("finite", |v| v.is_finite())
            .prop_map(|n| json!(n)),
        (-100_000i32..100_000).prop_map(|n| json!(f64::from(n) / 1000.0)),
        any_text().prop_map(|s| json!(s)),
        Just(Value::Null),
    ];
    leaf.prop_recursive(2, 12, 3, |inner| {
        prop_oneof![
            prop::collection::vec(inner.clone(), 0..3).prop_map(Value::Array),
            prop::collection::vec((any_text(), inner), 0..3)
                .prop_map(|e| Value::Object(e.into_iter().collect())),
        ]
    })
}

fn any_map() -> impl Strategy<Value = Map<String, Value>> {
    prop::collection::vec((any_text(), any_value()), 0..4).prop_map(|e| e.into_iter().collect())
}

fn any_part() -> impl Strategy<Value = Part> {
    (any_text(), any_text(), any_map(), any::<bool>(), any_text()).prop_map(
        |(id, factory, params, elastic, notes)| Part {
            id,
            factory,
            params,
            elastic,
            notes,
        },
    )
}

fn any_motion() -> impl Strategy<Value = PartMotion> {
    let axis = || {
        let axes = [WorldAxis::X, WorldAxis::Y, WorldAxis::Z];
        prop::option::of((0..3_usize).prop_map(move |i| axes[i]))
    };
    (any_text(), axis(), axis(), any_text()).prop_map(
        |(part, slides_along, turns_about, reason)| PartMotion {
            part,
            slides_along,
            turns_about,
            reason,
        },
    )
}

fn any_accepted() -> impl Strategy<Value = Accepted> {
    let parts = prop::collection::vec(any_text(), 0..3);
    (any_text(), parts, any_text()).prop_map(|(axiom, parts, reason)| Accepted {
        axiom,
        parts,
        reason,
    })
}

fn any_mate() -> impl Strategy<Value = Mate> {
    let end = || (any_text(), any_text()).prop_map(|(part, port)| End { part, port });
    let axioms = prop::collection::vec(any_text(), 0..3);
    (
        any_text(),
        0..ALL.len(),
        end(),
        end(),
        any_map(),
        axioms,
        any_text(),
    )
        .prop_map(|(id, kind, base, incoming, options, axioms, notes)| Mate {
            id,
            mate_type: ALL[kind].mate_type,
            base,
            incoming,
            options,
            axioms,
            notes,
        })
}

fn any_assembly() -> impl Strategy<Value = Assembly> {
    (
        (any_text(), any_text(), any_text()),
        prop::option::of(any_text()),
        (
            prop::option::of(any::<u32>()),
            prop::collection::vec(any_motion(), 0..3),
            prop::collection::vec(any_motion(), 0..3),
            prop::collection::vec(any_accepted(), 0..3),
        ),
        prop::collection::vec(any_part(), 0..5),
        prop::collection::vec(any_mate(), 0..5),
    )
        .prop_map(
            |(
                (id, description, notes),
                root,
                (intended_mobility, intended_motions, free, accept),
                parts,
                mates,
            )| Assembly {
                id,
                description,
                notes,
                root,
                intended_mobility,
                intended_motions,
                free,
                accept,
                parts,
                mates,
            },
        )
}

fn read(text: &str) -> Assembly {
    let draft = Draft::read(text);
    assert!(draft.faults.is_empty(), "{:?}\n{text}", draft.faults);
    draft.assembly.unwrap()
}

proptest! {
    #[test]
    fn a_specification_survives_its_text(assembly in any_assembly()) {
        let yaml = text::write(&assembly).unwrap();
        let there = read(&yaml);
        prop_assert_eq!(&there, &assembly.clone().normal(), "{}", &yaml);
        prop_assert_eq!(text::write(&there).unwrap(), yaml);
        prop_assert_eq!(there.hash().unwrap(), assembly.hash().unwrap());
    }

    #[test]
    fn the_tree_form_says_the_same(mut assembly in any_assembly()) {
        // A dictionary holds a name once.
        for (i, part) in assembly.parts.iter_mut().enumerate() {
            part.id.push_str(&format!("{i}"));
        }
        let tree = serde_json::to_string_pretty(&Tree::from(assembly.clone())).unwrap();
        // Beyond the first plane of Unicode, JSON text may hold what YAML does not; serde_json writes
        // it plainly, so that only control characters need another form.
        prop_assume!(!tree.chars().any(|c| c.is_control() && c != '\n'));
        prop_assume!(!tree.contains(['\u{feff}', '\u{2028}', '\u{2029}', '\u{fffe}', '\u{ffff}']));
        prop_assert_eq!(read(&tree), assembly.normal(), "{}", tree);
    }

    #[test]
    fn no_text_is_too_strange(text in any::<String>()) {
        let draft = Draft::read(&text);
        prop_assert!(draft.assembly.is_some() || !draft.faults.is_empty());
    }
}

#[test]
fn what_the_writer_made_does_not_change_when_it_is_read_and_written() {
    let written = "format: 1
assembly:
  id: \"on\"
  description: \"Single-stage spur gear reducer\"
  parts:
    - id: b
      factory: gear.spur
      params: {teeth: 20, module: 2.5, angle: 0.1}
    - id: a
      factory: bearing.ball
      params: {}
  mates: []
";
    let assembly = read(written);
    assert_eq!(assembly.parts[0].id, "b");
    let keys: Vec<&String> = assembly.parts[0].params.keys().collect();
    assert_eq!(keys, ["teeth", "module", "angle"]);
    assert_eq!(text::write(&assembly).unwrap(), written);
}
