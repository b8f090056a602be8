#![allow(clippy::all, dead_code, missing_docs)]
#[cfg(test)]
mod kit;
#[cfg(test)]
mod try_all {
    #[test]
    fn defaults() {
        for name in assemcad_factories::Registry::builtin().names() {
            let t = std::time::Instant::now();
            let r = std::panic::catch_unwind(|| super::kit::made(name, &serde_json::json!({})));
            match r {
                Ok(Ok(part)) => {
                    let dt = t.elapsed();
                    let v = part.solid.mass().unwrap();
                    println!(
                        "{name}: {dt:?} volume {} {:?}",
                        v.volume,
                        super::kit::faults(&part)
                    );
                    for p in &part.ports {
                        println!(
                            "   {} {:?} {:?} z{:?} x{:?} {:?}",
                            p.name, p.port_type, p.frame.origin, p.frame.z, p.frame.x, p.params
                        );
                    }
                }
                Ok(Err(e)) => println!("{name}: {e:?}"),
                Err(_) => println!("{name}: PANIC"),
            }
        }
    }
}
