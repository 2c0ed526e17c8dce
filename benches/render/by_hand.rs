//! The scenes as a person would write them for POV-Ray: objects side by side instead of unions of pairs, meshes of
//! triangles, the patterns and the finishes that POV-Ray has. What is written here is independent of the translation.

use std::collections::BTreeMap;
use std::fmt::Write;

/// A record without its ID: its type and its numbers.
type Record = (i32, Vec<f64>);

/// What the records of a scene say about each ID, in their order: first the definition.
struct Records(BTreeMap<u32, Vec<Record>>);

/// The scene in POV-Ray's language. Rays that count for less than `bailout` are left out.
pub fn written(text: &str, bailout: f64) -> String {
    let mut records: BTreeMap<u32, Vec<Record>> = BTreeMap::new();
    for line in text.lines() {
        let mut words = line.split_whitespace();
        let id = words.next().map(|w| w.parse().expect("an ID"));
        let ty = words.next().map(|w| w.parse().expect("a type"));
        let numbers = words.map(|w| w.parse().expect("a number")).collect();
        let (id, ty) = id.zip(ty).expect("a record");
        records.entry(id).or_default().push((ty, numbers));
    }
    let records = Records(records);
    let root = records.numbers(1, 9999);
    let [root, sky] = [0, 1].map(|i| root[i] as u32);
    let mut out = String::from(
        "#version 3.7;\n#default { pigment { rgb 1 } finish { ambient 1 diffuse 1 } }\n\
         global_settings { assumed_gamma 1 max_trace_level 11 ",
    );
    let mut lights = String::new();
    for all in records.0.values() {
        match &all[0] {
            (-401, level) => write!(out, "ambient_light rgb {} ", level[0]),
            (-402, level) => {
                let at = vector(&all[1].1);
                writeln!(lights, "light_source {{ {at} rgb {} }}", level[0])
            }
            // The eye, where it looks, what is up, and the height in degrees.
            (-501, numbers) => {
                let height = 2.0 * (numbers[9] / 2.0).to_radians().tan();
                writeln!(
                    lights,
                    "camera {{ location {} direction {} up {height}*y right {}*x }}",
                    vector(&numbers[..3]),
                    vector(&numbers[3..6]),
                    height * 4.0 / 3.0
                )
            }
            _ => Ok(()),
        }
        .expect(GROWS);
    }
    writeln!(out, "adc_bailout {bailout} }}").expect(GROWS);
    writeln!(out, "background {{ {} }}\n{lights}", records.colour(sky)).expect(GROWS);
    if text.contains(" 13 ") {
        out.push_str(GEODESIC);
    }
    out + &records.side_by_side(root)
}

const GROWS: &str = "a string takes everything";

/// An icosahedron, each of whose facets is split into four some times.
const GEODESIC: &str = "
#macro Facet(A, B, C, N)
  #if (N = 0)
    triangle { A, B, C }
  #else
    #local D = vnormalize(B + C);
    #local E = vnormalize(C + A);
    #local F = vnormalize(A + B);
    Facet(A, F, E, N - 1) Facet(F, B, D, N - 1) Facet(E, D, C, N - 1) Facet(D, E, F, N - 1)
  #end
#end
#macro Geodesic(N)
  #local L = 0.8506508083520399;
  #local S = 0.5257311121191336;
  mesh {
    #for (P, -1, 1, 2)
      #for (Q, -1, 1, 2)
        #for (R, -1, 1, 2)
          Facet(<0, S*P, L*Q>, <S*R, L*P, 0>, <L*R, 0, S*Q>, N)
        #end
        Facet(<0, S, L*Q>, <0, -S, L*Q>, <L*P, 0, S*Q>, N)
        Facet(<S, L*Q, 0>, <-S, L*Q, 0>, <0, S*Q, L*P>, N)
        Facet(<L*Q, 0, S>, <L*Q, 0, -S>, <S*Q, L*P, 0>, N)
      #end
    #end
    inside_vector y
  }
#end
";

fn vector(numbers: &[f64]) -> String {
    let numbers: Vec<String> = numbers.iter().map(f64::to_string).collect();
    format!("<{}>", numbers.join(", "))
}

impl Records {
    fn of(&self, id: u32) -> &[Record] {
        self.0.get(&id).map_or(&[], Vec::as_slice)
    }

    /// The numbers of a type of record with an ID; none where there is no such record.
    fn numbers(&self, id: u32, ty: i32) -> &[f64] {
        let found = self.of(id).iter().find(|(other, _)| *other == ty);
        found.map_or(&[], |(_, numbers)| numbers)
    }

    fn colour(&self, id: u32) -> String {
        match self.numbers(id, -701) {
            [] => "rgb 1".to_owned(),
            c => format!("rgb {}", vector(c)),
        }
    }

    /// The operands of an operation that is nothing but that.
    fn operands(&self, id: u32, operation: i32) -> Option<[u32; 2]> {
        match self.of(id) {
            [(ty, parts)] if *ty == operation => Some([0, 1].map(|i| parts[i] as u32)),
            _ => None,
        }
    }

    /// The objects of unions of pairs, one a line.
    fn side_by_side(&self, id: u32) -> String {
        let (mut all, mut open) = (Vec::new(), vec![id]);
        while let Some(id) = open.pop() {
            match self.operands(id, -101) {
                Some(parts) => open.extend(parts.iter().rev()),
                None => all.push(id),
            }
        }
        // Triangles are a mesh together.
        let is_facet = |id: &u32| matches!(self.of(*id), [(6, _)]);
        let (facets, others): (Vec<u32>, Vec<u32>) = all.into_iter().partition(is_facet);
        let mut out = String::new();
        for id in others {
            out += &self.object(id);
        }
        if !facets.is_empty() {
            let facets = facets.iter().map(|&id| {
                let at = self.numbers(id, 6).chunks(3).map(vector);
                format!("triangle {{ {} }}\n", at.collect::<Vec<_>>().join(", "))
            });
            let facets: String = facets.collect();
            writeln!(out, "mesh {{\n{facets}pigment {{ rgb 1 }} }}").expect(GROWS);
        }
        out
    }

    /// An object with its look and its changes.
    fn object(&self, id: u32) -> String {
        let all = self.of(id);
        let (ty, numbers) = &all[0];
        let head = match (*ty, numbers.as_slice()) {
            (9, [r]) => format!("sphere {{ 0, {r} "),
            (10, axes) => format!("sphere {{ 0, 1 scale {} ", vector(axes)),
            (11, [x, y, z, r]) => format!("sphere {{ <{x}, {y}, {z}>, {r} "),
            (12, corners) => {
                format!(
                    "box {{ {}, {} ",
                    vector(&corners[..3]),
                    vector(&corners[3..])
                )
            }
            (13, [r, level]) => format!("object {{ Geodesic({level}) scale {r} "),
            (14, [a, b]) => format!("torus {{ {a}, {b} "),
            (15, m) => {
                let axes = vector(&[m[0], m[5], m[10]]);
                format!("quadric {{ {axes}, 0, 0, {} ", m[15])
            }
            (16, [h, r]) => format!("cone {{ 0, 0, {h}*y, {r} "),
            (17, [h, r]) => {
                format!("union {{ cone {{ 0, 0, {h}*y, {r} }} cone {{ 0, 0, -{h}*y, {r} }} ")
            }
            (1, profile) => {
                let mut points = vec![vec![0.0, profile[2]]];
                points.extend(profile[1..].chunks(2).map(<[f64]>::to_vec));
                points.push(vec![0.0, profile[profile.len() - 1]]);
                let shown: Vec<String> = points.iter().map(|p| vector(p)).collect();
                let (count, points) = (shown.len(), shown.join(", "));
                format!("lathe {{ linear_spline {count}, {points} ")
            }
            (-101, parts) => {
                let parts = parts.iter().map(|&p| self.side_by_side(p as u32));
                format!("union {{ {}", parts.collect::<String>())
            }
            (-102, [tube, _]) if !self.numbers(*tube as u32, 15).is_empty() => {
                "cylinder { -0.7*y, 0.7*y, 0.5 ".to_owned()
            }
            (-102, parts) => {
                let parts = parts.iter().map(|&p| self.object(p as u32));
                format!("intersection {{ {}", parts.collect::<String>())
            }
            (-103, parts) => {
                let (mut from, mut cut) = (parts[0] as u32, vec![parts[1] as u32]);
                while let Some([before, part]) = self.operands(from, -103) {
                    (from, _) = (before, cut.push(part));
                }
                let cut = cut.iter().rev().map(|&p| self.side_by_side(p));
                format!(
                    "difference {{ {}{}",
                    self.object(from),
                    cut.collect::<String>()
                )
            }
            (ty, _) => unreachable!("the scenes have no type {ty}"),
        };
        let mut out = head + &self.look(id);
        for (ty, numbers) in &all[1..] {
            let [axis, of] = [numbers.get(1), numbers.first()].map(|n| n.copied().unwrap_or(0.0));
            match ty {
                -1 => write!(out, "translate {} ", vector(numbers)),
                -2 => write!(out, "rotate {of}*{} ", ['x', 'y', 'z'][axis as usize - 1]),
                -3 => write!(out, "scale {} ", vector(numbers)),
                _ => Ok(()),
            }
            .expect(GROWS);
        }
        out + "}\n"
    }

    fn look(&self, id: u32) -> String {
        let texture = self.numbers(id, -299).first().map_or(0, |&t| t as u32);
        let optics = self.numbers(id, -201);
        // It has that of what it is a part of.
        if texture == 0 && optics.is_empty() && self.numbers(id, -701).is_empty() {
            return String::new();
        }
        let checker = |at: usize, numbers: &[f64]| {
            let [a, b] = [at, at + 1].map(|i| self.colour(numbers[i] as u32));
            format!("checker {a} {b}")
        };
        let mut pigment = match self.of(texture) {
            [(-399, numbers), ..] => {
                let (u, v) = (1.0 / numbers[0], 1.0 / numbers[1]);
                let pattern = checker(2, numbers);
                return format!("pigment {{ uv_mapping {pattern} scale <{u}, {v}, 1> }} ");
            }
            [(-302, numbers), ..] => format!("{} scale {}", checker(0, numbers), numbers[2]),
            _ => self.colour(id),
        };
        let mut rest = String::new();
        if let [diffuse, mirrored, through] = optics {
            // POV-Ray's diffuse light is that of the part that is not clear.
            let diffuse = diffuse / (1.0 - through);
            if *through > 0.0 {
                write!(pigment, " transmit {through}").expect(GROWS);
            }
            rest =
                format!("finish {{ ambient {diffuse} diffuse {diffuse} reflection {mirrored} }} ");
        }
        if let [index, ..] = self.numbers(id, -203) {
            write!(rest, "interior {{ ior {index} }} ").expect(GROWS);
        }
        format!("pigment {{ {pigment} }} {rest}")
    }
}
