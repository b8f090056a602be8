//! STEP out and in again. One test only: the first export of a process is what is looked at.

use assemcad_kernel::Shape;
use assemcad_kernel::step::{Assembly, Header, Instance, Part, Product, Tree, read, write};
use assemcad_model::frame::{Frame, Placement, Rows};

fn header() -> Header {
    Header {
        file_name: "bench.step".into(),
        description: vec!["A bench".into(), "revision 'A'".into()],
        author: vec!["A. Author".into()],
        organization: vec!["Org".into()],
        preprocessor: "assemcad 0.1.0".into(),
        originating_system: "assemcad".into(),
        authorisation: "none".into(),
    }
}

#[test]
fn the_first_file_is_named_and_complete_and_reads_back() {
    let plate = Shape::cuboid(&Frame::WORLD, [100.0, 50.0, 10.0]).unwrap();
    let leg = Shape::cylinder(&Frame::WORLD, 4.0, 30.0).unwrap();
    let tree = Tree {
        parts: vec![
            Part {
                name: "plate",
                shape: &plate,
                color: Some([0.2, 0.4, 0.6]),
            },
            Part {
                name: "leg",
                shape: &leg,
                color: None,
            },
        ],
        assemblies: vec![
            Assembly {
                name: "trestle",
                instances: vec![
                    Instance {
                        name: "leg_1",
                        of: Product::Part(1),
                        placement: Placement::translation(0.0, 10.0, -30.0),
                    },
                    Instance {
                        name: "leg_2",
                        of: Product::Part(1),
                        placement: Placement::translation(0.0, 40.0, -30.0),
                    },
                ],
            },
            Assembly {
                name: "bench",
                instances: vec![
                    Instance {
                        name: "top",
                        of: Product::Part(0),
                        placement: Placement::IDENTITY,
                    },
                    Instance {
                        name: "left",
                        of: Product::Assembly(0),
                        placement: Placement::translation(10.0, 0.0, 0.0),
                    },
                    Instance {
                        name: "right",
                        of: Product::Assembly(0),
                        placement: Placement::translation(90.0, 50.0, 0.0)
                            * Placement::rotation_z(180.0),
                    },
                ],
            },
        ],
    };
    let bytes = write(&tree, &header()).unwrap();
    let text = String::from_utf8(bytes.clone()).unwrap();
    if let Ok(to) = std::env::var("ASSEMCAD_TEST_STEP") {
        std::fs::write(to, &bytes).unwrap();
    }

    let head = text
        .split("ENDSEC;")
        .next()
        .unwrap()
        .replace(['\n', '\r'], "");
    for words in [
        "AP242",
        "'bench.step'",
        "'1970-01-01T00:00:00'",
        "'A. Author'",
        "'Org'",
        "'assemcad 0.1.0'",
        "'none'",
        "'A bench'",
        "'revision ''A'''",
    ] {
        assert!(head.contains(words), "{words} is missing in {head}");
    }
    let flat: String = text.replace(['\n', '\r'], "");
    let products: Vec<&str> = flat
        .split(";")
        .filter(|l| l.contains("=PRODUCT("))
        .collect();
    let products = if products.is_empty() {
        flat.split(";")
            .filter(|l| l.contains("= PRODUCT("))
            .collect()
    } else {
        products
    };
    assert_eq!(products.len(), 4, "{products:?}");
    for name in ["'plate'", "'leg'", "'trestle'", "'bench'"] {
        assert_eq!(
            products.iter().filter(|l| l.contains(name)).count(),
            1,
            "{name}"
        );
    }
    let uses: Vec<&str> = flat
        .split(";")
        .filter(|l| l.contains("NEXT_ASSEMBLY_USAGE_OCCURRENCE("))
        .collect();
    assert_eq!(uses.len(), 5);
    for name in ["'leg_1'", "'leg_2'", "'top'", "'left'", "'right'"] {
        assert_eq!(
            uses.iter().filter(|l| l.contains(name)).count(),
            1,
            "{name} in {uses:?}"
        );
    }
    assert!(!text.contains("Open CASCADE"), "{text}");
    assert!(text.contains("COLOUR_RGB"));
    assert!(!text.contains("INCH"));

    let leaves = read(&bytes).unwrap();
    let found: Vec<String> = leaves.iter().map(|l| l.path.join("/")).collect();
    assert_eq!(
        found,
        [
            "bench/top",
            "bench/left/leg_1",
            "bench/left/leg_2",
            "bench/right/leg_1",
            "bench/right/leg_2"
        ]
    );
    // The right trestle is turned by half a turn about (90, 50): its legs are at 90, 40 and 90, 10.
    let legs = core::f64::consts::PI * 16.0 * 30.0;
    let expected = [
        ("plate", 50_000.0, [50.0, 25.0, 5.0]),
        ("leg", legs, [10.0, 10.0, -15.0]),
        ("leg", legs, [10.0, 40.0, -15.0]),
        ("leg", legs, [90.0, 40.0, -15.0]),
        ("leg", legs, [90.0, 10.0, -15.0]),
    ];
    for (leaf, (product, volume, center)) in leaves.iter().zip(expected) {
        assert_eq!((leaf.product.as_str(), leaf.solids), (product, 1));
        assert!((leaf.volume - volume).abs() < 1e-9 * volume, "{leaf:?}");
        for (found, expected) in leaf.center.iter().zip(center) {
            assert!((found - expected).abs() < 1e-9, "{leaf:?}");
        }
    }
    let Rows([[.., x], ..]) = leaves[3].placement;
    assert!((x + leaves[3].bounds.min[0] - 86.0).abs() < 1e-6);

    // A second export differs in nothing but the counter of uses.
    let again = String::from_utf8(write(&tree, &header()).unwrap()).unwrap();
    let differing: Vec<&str> = flat_lines(&text)
        .zip(flat_lines(&again))
        .filter(|(a, b)| a != b)
        .map(|(a, _)| a)
        .collect();
    assert!(
        differing
            .iter()
            .all(|l| l.contains("NEXT_ASSEMBLY_USAGE") || l.contains("PRODUCT_DEFINITION_SHAPE")),
        "{differing:?}"
    );

    assert!(read(b"no STEP file").unwrap_err().message.contains("STEP"));
    let mut bad = header();
    bad.author = vec!["Jos\u{e9}".into()];
    assert!(write(&tree, &bad).unwrap_err().message.contains("author"));
    let loose = Tree {
        assemblies: tree.assemblies.into_iter().take(1).collect(),
        ..tree
    };
    assert!(
        write(&loose, &header())
            .unwrap_err()
            .message
            .contains("product plate is not used")
    );
}

fn flat_lines(text: &str) -> impl Iterator<Item = &str> {
    text.split(";")
}
