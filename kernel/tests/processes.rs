//! The same bytes from every process: addresses differ there, and nothing may hang on them.

#[cfg(test)]
mod tests {
    use assemcad_kernel::step::{Assembly, Header, Instance, Part, Product, Tree, write};
    use assemcad_kernel::{Shape, replay};
    use assemcad_model::frame::{Frame, Placement};
    use assemcad_model::recipe::{EdgeSelector, FORMAT, Op, Recipe};

    /// Set in the processes that only print.
    const CHILD: &str = "ASSEMCAD_TEST_CHILD";

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

    fn solid() -> Shape {
        let ops = vec![
            Op::Box {
                at: Frame::WORLD,
                size: [10.0, 12.0, 14.0],
            },
            Op::Cylinder {
                at: slanted(),
                radius: 2.0,
                height: 25.0,
            },
            Op::Fuse { a: 0, b: 1 },
            Op::Sphere {
                at: Frame {
                    origin: [10.0, 12.0, 14.0],
                    ..Frame::WORLD
                },
                radius: 5.0,
            },
            Op::Cut { a: 2, b: 3 },
            Op::Fillet {
                of: 4,
                edges: EdgeSelector::Parallel {
                    direction: [0.0, 0.0, 1.0],
                },
                radius: 0.5,
            },
        ];
        let recipe = Recipe {
            format: FORMAT,
            ops,
            ports: Vec::new(),
        };
        replay(&recipe, &mut |_, _| {}).unwrap()
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

    fn child(cached: Option<&std::path::Path>) -> String {
        let mut command = std::process::Command::new(std::env::current_exe().unwrap());
        command
            .args(["--exact", "tests::every_process_agrees", "--nocapture"])
            .env(CHILD, "");
        if let Some(path) = cached {
            command.env(CHILD, path);
        }
        let output = command.output().unwrap();
        let text = String::from_utf8(output.stdout).unwrap();
        text.lines()
            .find_map(|l| l.split_once("DIGESTS "))
            .unwrap()
            .1
            .to_owned()
    }

    #[test]
    fn every_process_agrees() {
        if let Ok(path) = std::env::var(CHILD) {
            let shape = if path.is_empty() {
                solid()
            } else {
                Shape::from_bytes(&std::fs::read(path).unwrap()).unwrap()
            };
            let mesh = format!("{:?}", shape.mesh(0.1, 20.0).unwrap());
            let facts = format!("{:?} {:?}", shape.mass().unwrap(), shape.faces().unwrap());
            println!(
                "DIGESTS {:x} {:x} {:x} {:x}",
                digest(&shape.to_bytes().unwrap()),
                digest(&file(&shape)),
                digest(mesh.as_bytes()),
                digest(facts.as_bytes())
            );
            return;
        }
        let first = child(None);
        assert_eq!(child(None), first);
        assert_eq!(child(None), first);
        // A solid from the cache gives the same files as a fresh one.
        let path = std::env::temp_dir().join(format!("assemcad-solid-{}", std::process::id()));
        std::fs::write(&path, solid().to_bytes().unwrap()).unwrap();
        let cached = child(Some(&path));
        std::fs::remove_file(&path).unwrap();
        assert_eq!(cached, first);
    }
}
