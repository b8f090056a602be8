//! Verdicts on pairs of parts.

use super::{Allowed, Judged, judge};
use assemcad_geometry::ENTERS;
use assemcad_kernel::protocol::CommonVolume;
use assemcad_model::diagnostic::{Code, Diagnostic};
use assemcad_model::report::{Overlapping, Verdict};

fn verdict(volume: f64, inside: u32) -> Verdict {
    warned(volume, inside, Vec::new())
}

fn warned(volume: f64, inside: u32, warnings: Vec<String>) -> Verdict {
    let v = CommonVolume {
        volume,
        place: None,
        warnings,
        samples: 1000,
        inside,
        sampled_volume: 500.0,
    };
    judge("a", "b", Ok(v), 0.001, &Allowed::default()).verdict
}

#[test]
fn a_boolean_is_not_believed_alone() {
    assert_eq!(verdict(0.0, 0), Verdict::Pass);
    assert_eq!(verdict(0.0011, 0), Verdict::Fail);
    // The boolean says nothing, 30 of 1000 points say 15 mm3: so many are no misclassification.
    assert_eq!(verdict(0.0, 30), Verdict::Fail);
    assert_eq!(verdict(0.0, 5), Verdict::Indeterminate);
    assert_eq!(verdict(f64::NAN, 0), Verdict::Indeterminate);
    assert_eq!(warned(0.0, 0, vec!["bad face".to_owned()]), Verdict::Pass);
    assert_eq!(
        warned(0.0, 1, vec!["bad face".to_owned()]),
        Verdict::Indeterminate
    );
    assert_eq!(
        warned(0.0, 0, vec![ENTERS.to_owned()]),
        Verdict::Indeterminate
    );
    let lost = Diagnostic::error(Code::WorkerCrashed, "", "");
    assert_eq!(
        judge("a", "b", Err(lost), 0.001, &Allowed::default()).verdict,
        Verdict::Indeterminate
    );
}

/// A press fit that means 6.3 mm3, up to `more` beyond.
fn pressed(volume: f64, inside: u32, more: f64) -> Judged {
    let v = CommonVolume {
        volume,
        place: None,
        warnings: Vec::new(),
        samples: 1000,
        inside,
        sampled_volume: 500.0,
    };
    let allowed = Allowed {
        meant: Vec::new(),
        mates: vec!["m".to_owned()],
        least_mm3: 6.3,
        most_mm3: 6.3 + more,
        why: vec!["the ring".to_owned()],
    };
    judge("a", "b", Ok(v), 0.001, &allowed)
}

#[test]
fn an_overlap_that_a_mate_means_is_compared_with_it() {
    // 6.3 of 500 mm3 are 12.6 of 1000 points.
    let is = |j: Judged, verdict, class| {
        assert_eq!((j.verdict, j.class), (verdict, class), "{:?}", j.finding);
    };
    is(pressed(6.3, 12, 0.0), Verdict::Pass, Overlapping::Expected);
    is(pressed(6.35, 12, 0.0), Verdict::Pass, Overlapping::Expected);
    is(pressed(6.38, 12, 0.0), Verdict::Fail, Overlapping::Clash);
    is(pressed(6.38, 12, 1.0), Verdict::Pass, Overlapping::Expected);
    is(pressed(6.2, 12, 0.0), Verdict::Fail, Overlapping::Expected);
    is(pressed(0.0, 0, 0.0), Verdict::Fail, Overlapping::Expected);
    // The points do not agree with the boolean: 100 of 1000 are 50 mm3.
    is(
        pressed(6.3, 100, 0.0),
        Verdict::Indeterminate,
        Overlapping::Unknown,
    );
    is(
        pressed(0.0, 12, 0.0),
        Verdict::Indeterminate,
        Overlapping::Unknown,
    );
    is(
        pressed(f64::NAN, 12, 0.0),
        Verdict::Indeterminate,
        Overlapping::Unknown,
    );
}
