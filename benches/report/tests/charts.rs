//! Charts and pages drawn from the committed numbers: the same each time, equal to the committed files, well formed.

use reference::registry::Origin;
use report::chart::key::point_name;
use report::{render, run};

#[test]
fn charts_and_pages_are_those_committed() {
    let numbers = run::committed().expect("the ledger is committed");
    let stale = run::stale_drawings(&numbers).expect("charts can be drawn");
    assert!(
        stale.is_empty(),
        "run `cargo run --release -p report -- --render`: {}",
        stale.join("; ")
    );
}

#[test]
fn charts_are_deterministic_and_follow_the_numbers() {
    let mut numbers = run::committed().expect("the ledger is committed");
    let first = render::charts(&numbers).expect("drawn");
    assert_eq!(first, render::charts(&numbers).expect("drawn"));
    for e in &mut numbers.entries {
        e.ns *= 1.5;
    }
    let moved = render::charts(&numbers).expect("drawn");
    for ((path, a), (_, b)) in first.iter().zip(&moved) {
        let by_time = path.to_string_lossy().contains("error_time");
        // Equal factors on all times move the axis, not the picture's sense; the text differs all the same.
        assert_eq!(a != b, by_time, "{}", path.display());
    }
}

#[test]
fn every_method_is_on_its_chart_and_every_tag_is_closed() {
    let numbers = run::committed().expect("the ledger is committed");
    for (path, text) in render::charts(&numbers).expect("drawn") {
        assert!(!text.contains("NaN") && !text.contains("inf "), "{}", path.display());
        for tag in ["text", "tspan", "defs", "svg", "title", "pattern"] {
            let open = text.matches(&format!("<{tag} ")).count() + text.matches(&format!("<{tag}>")).count();
            assert_eq!(
                open,
                text.matches(&format!("</{tag}>")).count(),
                "{tag} in {}",
                path.display()
            );
        }
        let name = path.file_name().and_then(|n| n.to_str()).expect("a name");
        if let Some(function) = name.strip_suffix("_error_time.svg") {
            let mut shown = numbers.entries.iter().filter(|e| e.function == function && e.ns > 0.0);
            // Features add peers: without any of them each chart still sets ours against another.
            let ours = |origin| shown.clone().any(|e| (e.origin == Origin::Ours) == origin);
            assert!(ours(true) && ours(false), "{function}");
            // A label ends here or with the size of an error; the key puts a colon after the name.
            let missing = shown.find(|e| {
                let label = point_name(e);
                !text.contains(&format!(">{label}<")) && !text.contains(&format!(">{label} ("))
            });
            assert!(
                missing.is_none(),
                "{:?} is not on {}",
                missing.map(|e| &e.method),
                path.display()
            );
        }
    }
}

#[test]
fn a_chart_with_many_more_methods_still_finds_room_for_every_label() {
    let numbers = run::committed().expect("the ledger is committed");
    let mut entries = numbers.entries.clone();
    for e in &numbers.entries {
        for (suffix, factor) in [("wide", 0.4), ("wider", 0.03)] {
            if e.origin != Origin::Peer && e.call == "scalar" {
                let mut more = e.clone();
                more.method = format!("{}_{suffix}", e.method);
                more.call = "slice".to_string();
                more.slice_of = e.method.clone();
                more.ns *= factor;
                entries.push(more);
            }
        }
    }
    for function in ["sine_integral", "sinc_squared_integral", "faddeeva_w"] {
        if !entries.iter().any(|e| e.function == function) {
            continue;
        }
        let text = report::chart::error_time::draw(function, "crowded", &entries).expect("room for all");
        for e in entries.iter().filter(|e| e.function == function) {
            assert!(
                text.contains(&format!(">{}", e.method.replace('_', " "))),
                "{}",
                e.method
            );
        }
    }
}
