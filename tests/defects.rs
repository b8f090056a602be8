//! A sample of the defects in CI; `make faults` puts all of them before the server.

use std::path::Path;

use crate::kit::Kit;
use crate::suite::{Told, cases};

#[test]
fn nothing_wrong_passes_and_nothing_right_fails() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../tests/defects");
    let mut kit = Kit::new();
    let mut found = 0;
    for (i, case) in cases(&folder).iter().enumerate() {
        match case.mechanism {
            None => assert_eq!(
                case.put(&mut kit.session),
                Told::Pass,
                "{}: {}",
                case.id,
                case.why
            ),
            Some(_) if i % 4 == 0 => {
                let told = case.put(&mut kit.session);
                assert_eq!(
                    told,
                    Told::Found,
                    "{} ({}): {}",
                    case.id,
                    case.form,
                    case.why
                );
                found += 1;
            }
            Some(_) => {}
        }
    }
    assert!(found > 20, "{found}");
}
