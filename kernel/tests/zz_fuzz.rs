//! tmp
#[cfg(test)]
mod t {
    use assemcad_kernel::pair::*;
    use assemcad_kernel::*;
    use assemcad_model::frame::*;
    fn rnd(s: &mut u64) -> f64 {
        *s ^= *s << 13;
        *s ^= *s >> 7;
        *s ^= *s << 17;
        (*s >> 11) as f64 / (1u64 << 53) as f64
    }
    #[test]
    fn reread() {
        let a=Shape::cuboid(&Frame::WORLD,[10.;3]).unwrap();
        let b=Shape::sphere(&Frame{origin:[1.,2.,3.],..Frame::WORLD},4.5).unwrap();
        let x=a.cut(&b).unwrap();
        let mut by=x.to_bytes().unwrap();
        for i in 0..5 { let n=Shape::from_bytes(&by).unwrap().to_bytes().unwrap();
            let d=by.iter().zip(&n).position(|(a,b)|a!=b);
            let count=by.iter().zip(&n).filter(|(a,b)|a!=b).count();
            println!("pass {i} len {} {} first diff {d:?} count {count} {:?}", by.len(), n.len(), d.map(|d|(by[d.saturating_sub(40)..(d+40).min(by.len())].escape_ascii().to_string(), n[d.saturating_sub(40)..(d+40).min(n.len())].escape_ascii().to_string())));
            by=n; }
    }
    #[test]
    fn fuzz() {
        let mut s = 0x9E3779B97F4A7C15u64;
        let mut stats = std::collections::BTreeMap::<String, u32>::new();
        let n: usize = std::env::var("N")
            .map(|v| v.parse().unwrap())
            .unwrap_or(100);
        let mut h: u64 = 0xcbf29ce484222325;
        for k in 0..n {
            let grid = rnd(&mut s) < 0.6;
            let mut prim = |s: &mut u64| {
                let q = |s: &mut u64, a: f64, b: f64| {
                    let v = a + (b - a) * rnd(s);
                    if grid { v.round() } else { v }
                };
                let o = [q(s, -5., 5.), q(s, -5., 5.), q(s, -5., 5.)];
                let p = Placement::translation(o[0], o[1], o[2])
                    * if grid {
                        Placement::rotation_x(90. * (rnd(s) * 4.).floor())
                    } else {
                        Placement::rotation_about(
                            [0.; 3],
                            [rnd(s) - 0.5, rnd(s) - 0.5, rnd(s) + 0.01],
                            360. * rnd(s),
                        )
                        .unwrap()
                    };
                let f = p.frame(&Frame::WORLD);
                match (rnd(s) * 4.) as u32 {
                    0 => Shape::cuboid(&f, [q(s, 2., 8.), q(s, 2., 8.), q(s, 2., 8.)]),
                    1 => Shape::cylinder(&f, q(s, 1., 5.), q(s, 2., 10.)),
                    2 => Shape::cone(&f, q(s, 2., 5.), 0.5, q(s, 2., 9.)),
                    _ => Shape::sphere(&f, q(s, 2., 5.)),
                }
                .unwrap()
            };
            let a = prim(&mut s);
            let b = prim(&mut s);
            let c = common(&a, &Placement::IDENTITY, &b, &Placement::IDENTITY);
            let sm =
                sampled_common(&a, &Placement::IDENTITY, &b, &Placement::IDENTITY, 1000).unwrap();
            let cv = match &c {
                Ok(c) => {
                    if !c.warnings.is_empty() {
                        *stats.entry(format!("warn {:?}", c.warnings)).or_default() += 1;
                    }
                    c.volume
                }
                Err(e) => {
                    *stats
                        .entry(format!("common err {}", e.message))
                        .or_default() += 1;
                    println!("{k} ERR {}", e.message);
                    f64::NAN
                }
            };
            if (cv - sm.volume()).abs() > 0.05 * sm.box_volume {
                println!(
                    "{k} MISMATCH common {cv} sampled {} box {} grid {grid}",
                    sm.volume(),
                    sm.box_volume
                );
                *stats.entry("mismatch".into()).or_default() += 1;
            }
            let (va, vb) = (a.mass().unwrap().volume, b.mass().unwrap().volume);
            for (name, r, exp) in [
                ("fuse", a.fuse(&b), va + vb - cv),
                ("cut", a.cut(&b), va - cv),
                ("common", a.common(&b), cv),
            ] {
                match r {
                    Ok(x) => {
                        let v = x.mass().unwrap().volume;
                        let e = (v - exp).abs() / (va + vb);
                        let by = x.to_bytes().unwrap();
                        for c in &by {
                            h = (h ^ *c as u64).wrapping_mul(0x100000001b3);
                        }
                        if Shape::from_bytes(&by).unwrap().to_bytes().unwrap() != by {let mut p=by.clone(); for q in 0..5 {let n=Shape::from_bytes(&p).unwrap().to_bytes().unwrap(); let d=p.iter().zip(&n).position(|(a,b)|a!=b); println!("REREAD {k} {name} pass {q} len {} {} diff {d:?} count {} {:?}",p.len(),n.len(),p.iter().zip(&n).filter(|(a,b)|a!=b).count(), d.map(|d|(p[d.saturating_sub(60)..(d+40).min(p.len())].escape_ascii().to_string(), n[d.saturating_sub(60)..(d+40).min(n.len())].escape_ascii().to_string()))); p=n;}
                            *stats.entry("bytes differ on reread".into()).or_default() += 1;
                        }
                        let bucket = if e < 1e-12 {
                            "<1e-12"
                        } else if e < 1e-9 {
                            "<1e-9"
                        } else if e < 1e-7 {
                            "<1e-7"
                        } else if e < 1e-5 {
                            "<1e-5"
                        } else {
                            println!("{k} {name} off {e:e} v {v} exp {exp} grid {grid}");
                            ">1e-5"
                        };
                        *stats.entry(format!("{name} ok {bucket}")).or_default() += 1;
                    }
                    Err(e) => {
                        let m: String = e
                            .message
                            .split(';')
                            .next()
                            .unwrap()
                            .chars()
                            .filter(|c| !c.is_ascii_digit() && *c != '.')
                            .collect();
                        *stats.entry(format!("{name} {:?} {m}", e.kind)).or_default() += 1;
                        if e.kind != Kind::Refused {
                            println!("{k} {name} {}", e.message)
                        }
                    }
                }
            }
        }
        println!("HASH {h:x}");
        for (k, v) in stats {
            println!("{v:5} {k}");
        }
    }
}
