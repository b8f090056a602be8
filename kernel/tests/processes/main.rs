//! The same bytes from every process: addresses differ there, and nothing may hang on them.

#![cfg(test)]

mod recipes;
mod verbs;

use std::collections::BTreeMap;
use std::thread;

use assemcad_kernel::step::{Assembly, Header, Instance, Part, Product, Tree, write};
use assemcad_kernel::{Shape, replay};
use assemcad_model::frame::{Frame, Placement};

/// Set in the processes that only print: what they make it of, and in which order.
const CHILD: &str = "ASSEMCAD_TEST_CHILD";
/// How many processes make everything.
const PROCESSES: usize = 6;
/// What stands before a line of results.
const MARK: &str = "DIGEST ";

fn slanted() -> Frame {
    let turn = Placement::rotation_about([1.0, 2.0, 3.0], [1.0, -2.0, 0.5], 37.0).unwrap();
    let center = Frame {
        origin: [5.0, 6.0, 7.0],
        ..Frame::WORLD
    };
    Frame {
        origin: center.origin,
        ..turn.frame(&center)
    }
}

fn file(shape: &Shape) -> Vec<u8> {
    let instance = |name, placement| Instance {
        name,
        of: Product::Part(0),
        placement,
    };
    let tree = Tree {
        parts: vec![Part {
            name: "part",
            shape,
            color: Some([1.0, 0.5, 0.25]),
        }],
        assemblies: vec![Assembly {
            name: "pair",
            instances: vec![
                instance("one", Placement::IDENTITY),
                instance("two", slanted().placement().unwrap()),
            ],
        }],
    };
    let text = || "text".to_owned();
    let header = Header {
        file_name: text(),
        description: vec![text()],
        author: vec![text()],
        organization: vec![text()],
        preprocessor: text(),
        originating_system: text(),
        authorisation: text(),
    };
    write(&tree, &header).unwrap()
}

/// FNV-1a, enough to tell two runs apart.
fn digest(bytes: &[u8]) -> u64 {
    bytes.iter().fold(0xcbf2_9ce4_8422_2325, |h, b| {
        (h ^ u64::from(*b)).wrapping_mul(0x0100_0000_01b3)
    })
}

/// What becomes of a solid: its bytes, its triangles and what is found out about it.
fn derived(shape: &Shape) -> String {
    let mesh = format!("{:?}", shape.mesh(0.1, 20.0).unwrap());
    let facts = format!("{:?} {:?}", shape.mass().unwrap(), shape.faces().unwrap());
    format!(
        "{:x} {:x} {:x}",
        digest(&shape.to_bytes().unwrap()),
        digest(mesh.as_bytes()),
        digest(facts.as_bytes())
    )
}

fn replayed(recipe: &assemcad_model::recipe::Recipe) -> Shape {
    replay(recipe, &mut |_, _| {}).unwrap().solid
}

/// Makes everything and prints one line each.
fn print(backwards: bool) {
    let mut verbs: Vec<_> = verbs::VERBS.iter().collect();
    let mut recipes = recipes::recipes();
    if backwards {
        verbs.reverse();
        recipes.reverse();
    }
    let print_recipes = || {
        for (name, recipe) in &recipes {
            println!("{MARK}{name}\t{}", derived(&replayed(recipe)));
        }
    };
    if backwards {
        print_recipes();
    }
    for (name, make) in verbs {
        let found: Vec<String> = make()
            .iter()
            .map(|shape| format!("{:x}", digest(&shape.to_bytes().unwrap())))
            .collect();
        println!("{MARK}{name}\t{}", found.join(" "));
    }
    if !backwards {
        print_recipes();
    }
}

/// What a fresh process prints, by name.
fn child(order: &str) -> BTreeMap<String, String> {
    let output = std::process::Command::new(std::env::current_exe().unwrap())
        .args(["--exact", "every_process_agrees", "--nocapture"])
        .env(CHILD, order)
        .output()
        .unwrap();
    let text = String::from_utf8(output.stdout).unwrap();
    text.lines()
        .filter_map(|line| line.split_once(MARK)?.1.split_once('\t'))
        .map(|(name, found)| (name.to_owned(), found.to_owned()))
        .collect()
}

#[test]
fn every_process_agrees() {
    if let Ok(order) = std::env::var(CHILD) {
        match order.strip_prefix("file ") {
            Some(path) => {
                let shape = Shape::from_bytes(&std::fs::read(path).unwrap()).unwrap();
                println!(
                    "{MARK}first\t{} {:x}",
                    derived(&shape),
                    digest(&file(&shape))
                );
            }
            // The first export of a process: a second one numbers its instances on.
            None if order == "fresh" => {
                let shape = replayed(&recipes::recipes()[0].1);
                println!(
                    "{MARK}first\t{} {:x}",
                    derived(&shape),
                    digest(&file(&shape))
                );
            }
            None => print(order == "backwards"),
        }
        return;
    }
    // The last one makes everything after what it otherwise makes before.
    let orders: Vec<&str> = (0..PROCESSES)
        .map(|_| "forwards")
        .chain(["backwards"])
        .collect();
    let (left, right) = orders.split_at(PROCESSES / 2);
    let all = |some: &[&str]| -> Vec<_> { some.iter().map(|order| child(order)).collect() };
    let found: Vec<BTreeMap<String, String>> = thread::scope(|scope| {
        let first = scope.spawn(|| all(left));
        let second = all(right);
        first.join().unwrap().into_iter().chain(second).collect()
    });
    let names = verbs::VERBS.len() + recipes::recipes().len();
    for other in &found {
        assert_eq!(other.len(), names, "a process ended early");
    }
    let unstable: Vec<&String> = found[0]
        .iter()
        .filter(|(name, digests)| found.iter().any(|other| other[*name] != **digests))
        .map(|(name, _)| name)
        .collect();
    assert!(unstable.is_empty(), "these differ: {unstable:?}");

    // A solid from the cache gives the same files as a fresh one.
    let (_, recipe) = &recipes::recipes()[0];
    let path = std::env::temp_dir().join(format!("assemcad-solid-{}", std::process::id()));
    std::fs::write(&path, replayed(recipe).to_bytes().unwrap()).unwrap();
    let cached = child(&format!("file {}", path.display()));
    std::fs::remove_file(&path).unwrap();
    assert_eq!(cached["first"], child("fresh")["first"]);
    assert_eq!(cached["first"], child("fresh")["first"]);
}
