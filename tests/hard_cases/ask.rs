//! Questions to `zpg probe`, and its answers held to the exact ones.

use super::exact::algebra::{Q, q, to_f64};
use super::exact::{Answer, Exact};
use dashu_int::{IBig, UBig};
use serde_json::Value;
use std::io::Write;
use std::path::{Path, PathBuf};
use std::process::Stdio;

#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Precision {
    F32,
    F64,
    Dd,
}

impl Precision {
    pub fn name(self) -> &'static str {
        match self {
            Precision::F32 => "f32",
            Precision::F64 => "f64",
            Precision::Dd => "dd",
        }
    }

    /// The machine epsilon; for pairs of doubles the one their errors are promised in.
    pub fn epsilon(self) -> f64 {
        match self {
            Precision::F32 => f32::EPSILON.into(),
            Precision::F64 => f64::EPSILON,
            Precision::Dd => 0.5f64.powi(100),
        }
    }
}

#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Ray {
    pub origin: [f64; 3],
    pub direction: [f64; 3],
}

impl Ray {
    pub fn new(origin: [f64; 3], direction: [f64; 3]) -> Ray {
        Ray { origin, direction }
    }

    pub fn from_to(origin: [f64; 3], target: [f64; 3]) -> Ray {
        let direction = std::array::from_fn(|i| target[i] - origin[i]);
        Ray { origin, direction }
    }

    pub fn parse(text: &str) -> Ray {
        let n: Vec<f64> = text
            .split_whitespace()
            .map(|w| w.parse().unwrap())
            .collect();
        let [a, b, c, d, e, f] = n[..] else {
            panic!("not a ray: {text}")
        };
        Ray::new([a, b, c], [d, e, f])
    }

    /// The ray as a precision sees it.
    pub fn seen(self, precision: Precision) -> Ray {
        match precision {
            Precision::F32 => Ray {
                origin: self.origin.map(|x| f64::from(x as f32)),
                direction: self.direction.map(|x| f64::from(x as f32)),
            },
            _ => self,
        }
    }
}

#[derive(Debug, Clone)]
pub struct Hit {
    pub t: Q,
    pub point: [Q; 3],
    pub normal: [f64; 3],
    pub entering: Option<bool>,
}

/// What `zpg probe` says about a ray.
#[derive(Debug, Clone)]
pub struct Said {
    pub inside: bool,
    pub hits: Vec<Hit>,
}

impl Said {
    pub fn t(&self) -> Vec<f64> {
        self.hits.iter().map(|h| to_f64(&h.t)).collect()
    }
}

/// A decimal number, without rounding.
pub fn decimal(text: &str) -> Q {
    let (mantissa, exponent) = text.split_once(['e', 'E']).unwrap_or((text, "0"));
    let (whole, fraction) = mantissa.split_once('.').unwrap_or((mantissa, ""));
    let digits: IBig = format!("{whole}{fraction}").parse().unwrap();
    let exponent = exponent.parse::<i64>().unwrap() - fraction.len() as i64;
    let power = UBig::from(10u32).pow(exponent.unsigned_abs() as usize);
    if exponent < 0 {
        Q::from_parts(digits, power)
    } else {
        Q::from(digits * IBig::from(power))
    }
}

/// Numbers are numbers, in double-double strings of 32 significant digits.
fn number(value: &Value, precision: Precision) -> Q {
    match (value, precision) {
        (Value::String(s), Precision::Dd) => {
            let mantissa = s.split(['e', 'E']).next().unwrap();
            let digits = mantissa.bytes().filter(u8::is_ascii_digit).count();
            assert!(digits >= 32 || decimal(s).is_zero(), "{s}");
            decimal(s)
        }
        (Value::Number(n), Precision::F32 | Precision::F64) => q(n.as_f64().unwrap()),
        _ => panic!("{value} in {precision:?}"),
    }
}

fn float(value: &Value) -> f64 {
    match value {
        Value::String(s) => s.parse().unwrap(),
        _ => value.as_f64().unwrap(),
    }
}

fn three<T>(value: &Value, of: impl Fn(&Value) -> T) -> [T; 3] {
    std::array::from_fn(|i| of(&value[i]))
}

/// The answers to many rays about a scene, or about one of its objects.
pub fn ask(scene: &Path, object: Option<u32>, rays: &[Ray], precision: Precision) -> Vec<Said> {
    let mut command = crate::support::program::command();
    command.arg("probe").arg(scene);
    command.args(["--rays", "-", "--precision", precision.name()]);
    if let Some(id) = object {
        command.args(["--object", &id.to_string()]);
    }
    let mut child = command
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .unwrap();
    let mut stdin = child.stdin.take().unwrap();
    let mut input = String::new();
    for Ray {
        origin: [a, b, c],
        direction: [d, e, f],
    } in rays
    {
        input += &format!("{a:e} {b:e} {c:e} {d:e} {e:e} {f:e}\n");
    }
    let writer = std::thread::spawn(move || stdin.write_all(input.as_bytes()).is_ok());
    let out = child.wait_with_output().unwrap();
    writer.join().unwrap();
    let errors = String::from_utf8_lossy(&out.stderr);
    assert_eq!(out.status.code(), Some(0), "{}: {errors}", scene.display());
    let text = String::from_utf8(out.stdout).unwrap();
    let said: Vec<Said> = text
        .lines()
        .map(|line| {
            let answer: Value = serde_json::from_str(line).unwrap();
            let exact = |v: &Value| number(v, precision);
            let hits = answer["hits"].as_array().unwrap().iter().map(|h| Hit {
                t: exact(&h["t"]),
                point: three(&h["point"], exact),
                normal: three(&h["normal"], float),
                entering: h["entering"].as_bool(),
            });
            Said {
                inside: answer["inside_at_origin"].as_bool().unwrap(),
                hits: hits.collect(),
            }
        })
        .collect();
    assert_eq!(said.len(), rays.len());
    said
}

/// Crossings ascend, and those of solids alternate.
pub fn orderly(said: &Said, what: &str) {
    let mut inside = said.inside;
    let mut last = Q::ZERO;
    for (k, hit) in said.hits.iter().enumerate() {
        // Equal only where printing in the last place makes them so.
        assert!(
            hit.t > last || (k > 0 && hit.t == last),
            "{what}: {:?}",
            said.t()
        );
        last = hit.t.clone();
        if let Some(entering) = hit.entering {
            assert!(entering != inside, "{what}: {:?}", said.t());
            inside = entering;
        }
    }
}

/// Holds an answer to the exact one: as many crossings, in the same directions, and every point,
/// the reported one and that at the reported t, at most 64 ε × max(|origin|, |point|, size) from
/// the true surface.
pub fn held(exact: &Exact, ray: Ray, said: &Said, precision: Precision, what: &str) -> Answer {
    let ray = ray.seen(precision);
    let what = format!("{what} in {} {ray:?}", precision.name());
    let mut right = exact.trace(ray.origin, ray.direction);
    let list: Vec<f64> = right
        .changes
        .iter_mut()
        .map(|c| to_f64(&c.t.near(90)))
        .collect();
    assert_eq!(said.inside, right.inside_at_origin, "{what}");
    orderly(said, &what);
    assert_eq!(
        said.hits.len(),
        list.len(),
        "{what}: {:?} for {list:?}",
        said.t()
    );
    let (o, d) = (ray.origin.map(q), ray.direction.map(q));
    for (hit, change) in said.hits.iter().zip(&mut right.changes) {
        assert_eq!(hit.entering, change.entering, "{what}");
        let at_t = std::array::from_fn(|i| &o[i] + &d[i] * &hit.t);
        let far = length(hit.point.each_ref().map(to_f64));
        let scale = length(ray.origin).max(far).max(exact.size);
        let bound = 64.0 * precision.epsilon() * scale;
        for point in [&at_t, &hit.point] {
            let off = |s: &usize| exact.distance(*s, point);
            let off = change
                .surfaces
                .iter()
                .map(off)
                .fold(f64::INFINITY, f64::min);
            assert!(
                off <= bound,
                "{what}: {off:e} over {bound:e} at {:?}",
                said.t()
            );
        }
        // And it is this crossing: a line that touches is √(2rδ) along it while δ away from a
        // surface that bends with radius r.
        let along = to_f64(&(&hit.t - change.t.near(200))).abs();
        let reach = 2.0 * (2.0 * scale * bound).sqrt();
        assert!(along * length(ray.direction) <= reach, "{what}: {along:e}");
        assert!(
            (length(hit.normal) - 1.0).abs() <= 8.0 * f32::EPSILON as f64,
            "{what}"
        );
    }
    right
}

fn length(v: [f64; 3]) -> f64 {
    v.iter().map(|x| x * x).sum::<f64>().sqrt()
}

/// The file of a scene of the table.
pub fn data(name: &str) -> PathBuf {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/hard_cases");
    folder.join(name)
}

/// A scene written for the occasion.
pub struct Written {
    pub path: PathBuf,
    _folder: tempfile::TempDir,
}

impl Written {
    /// Object 2 is what is drawn.
    pub fn new(records: &str) -> Written {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("scene.zpg");
        std::fs::write(&path, format!("{records}\n1 9999 2 0\n")).unwrap();
        Written {
            path,
            _folder: folder,
        }
    }
}

/// The exact form of a scene file.
pub fn exact(path: &Path) -> Exact {
    Exact::new(&zpg::internals::analysis::file::load(path).unwrap().scene)
}

/// Asks about all rays and holds every answer to the exact one.
pub fn all_held(path: &Path, rays: &[Ray], precision: Precision) -> Vec<Answer> {
    let exact = exact(path);
    let what = path.file_name().unwrap().to_string_lossy().into_owned();
    let said = ask(path, None, rays, precision);
    let pairs = rays.iter().zip(&said);
    pairs
        .map(|(ray, said)| held(&exact, *ray, said, precision, &what))
        .collect()
}
