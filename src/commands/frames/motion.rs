//! How the numbers of a scene vary, and the scene of each frame.

use super::table::Table;
use super::{FrameArgs, Orbit, Range, Set, too_many};
use crate::analysis::Analysis;
use crate::analysis::parameters::{Number, has_values, records_of, with_values};
use crate::commands::camera;
use crate::diagnostics::{Complaint, Error, SourceFile, Value};
use crate::scene::Camera;
use crate::solids::{orbit, staging};
use crate::syntax::Record;
use crate::syntax::table::{Family, RecordKind};

/// The frames of a scene.
pub struct Frames {
    /// The scene as it stands in the file.
    source: SourceFile,
    all: Range,
    drawn: Range,
    motions: Vec<Motion>,
}

/// A way in which numbers of a scene vary from frame to frame.
enum Motion {
    Even {
        number: Number,
        from: f64,
        to: f64,
    },
    /// A value for each frame.
    Column {
        number: Number,
        values: Vec<f64>,
    },
    /// The numbers of a camera that goes around: by `degrees` in all frames together.
    Around {
        numbers: Vec<Number>,
        camera: Box<Camera>,
        orbit: orbit::Orbit,
        degrees: f64,
    },
}

/// The number of a camera's first numbers that are its position and direction; `AND_UP` counts the up direction, too.
const POSITION_AND_DIRECTION: usize = 6;
const AND_UP: usize = 9;

impl Motion {
    fn numbers(&self) -> &[Number] {
        match self {
            Motion::Even { number, .. } | Motion::Column { number, .. } => {
                std::slice::from_ref(number)
            }
            Motion::Around { numbers, .. } => numbers,
        }
    }

    /// The values at a frame, one for each of the numbers.
    fn values(&self, all: Range, frame: u32) -> Vec<f64> {
        let step = frame - all.first;
        match self {
            Motion::Even { from, .. } if step == 0 => vec![*from],
            // The last value is the given one, without rounding.
            Motion::Even { to, .. } if frame == all.last => vec![*to],
            Motion::Even { from, to, .. } => {
                let steps = f64::from(all.last - all.first);
                vec![from + (to - from) * f64::from(step) / steps]
            }
            Motion::Column { values, .. } => {
                values.get(step as usize).copied().into_iter().collect()
            }
            Motion::Around {
                numbers,
                camera,
                orbit,
                degrees,
            } => {
                let turned = degrees * f64::from(step) / f64::from(all.count());
                let camera = orbit.turned(camera, turned);
                let parts = [camera.position, camera.direction, camera.up];
                let values = parts.as_flattened().iter();
                values.copied().take(numbers.len()).collect()
            }
        }
    }
}

impl Frames {
    /// The frames of a scene that has no errors.
    ///
    /// # Errors
    ///
    /// The scene is in JSON, the frames do not fit together, a number is not there or is set twice, or a table cannot
    /// be read.
    pub fn of(args: &FrameArgs, analysis: &Analysis) -> Result<Frames, Error> {
        let source = &analysis.source;
        if !analysis.is_records() {
            let path = std::path::Path::new(&source.path);
            return Err(Complaint::new("frames-of-json").with("path", path).into());
        }
        let table = args.frames_from.as_deref().map(Table::read).transpose()?;
        let all = range(args.frames, table.as_ref())?;
        let drawn = args.only.unwrap_or(all);
        if !all.has(drawn) {
            let outside = Complaint::new("only-outside").with("frames", all.to_string());
            return Err(outside.into());
        }
        let mut wrong = Vec::new();
        let mut motions = Vec::new();
        for Set { name, from, to } in &args.set {
            match Number::named(analysis, name) {
                Ok(number) => motions.push(Motion::Even {
                    number,
                    from: *from,
                    to: *to,
                }),
                Err(why) => wrong.push(Complaint::new("in-set").with("why", why)),
            }
        }
        let table = table.unwrap_or_default();
        for (i, name) in table.names.iter().enumerate() {
            match Number::named(analysis, name) {
                Ok(number) => motions.push(Motion::Column {
                    number,
                    values: table.rows.iter().map(|row| row[i]).collect(),
                }),
                Err(why) => wrong.push(table.misnamed(i, why)),
            }
        }
        for turn in &args.orbit {
            match around(analysis, *turn) {
                Ok(turned) => motions.extend(turned),
                Err(Error::Request(why)) => wrong.push(Complaint::new("in-orbit").with("why", why)),
                Err(other) => return Err(other),
            }
        }
        wrong.extend(twice(&motions));
        match Complaint::several(wrong) {
            Some(all) => Err(all.into()),
            None => Ok(Frames {
                source: source.with_text(source.text.clone()),
                all,
                drawn,
                motions,
            }),
        }
    }

    /// The numbers of the frames that are drawn.
    pub fn drawn(&self) -> std::ops::RangeInclusive<u32> {
        self.drawn.first..=self.drawn.last
    }

    /// The number of frames that are drawn.
    pub fn count(&self) -> u32 {
        self.drawn.count()
    }

    /// Whether some cameras go around, but this one does not.
    pub fn leaves_behind(&self, camera: &Camera) -> bool {
        let mut around = (self.motions.iter()).filter_map(|motion| match motion {
            Motion::Around { camera, .. } => Some(camera.id),
            _ => None,
        });
        let first = around.next();
        first.is_some_and(|first| first != camera.id && !around.any(|id| id == camera.id))
    }

    /// The number of a frame in file names, with zeros in front: at least four digits, and as many as the last frame
    /// has.
    pub fn label(&self, frame: u32) -> String {
        let digits = self.all.last.to_string().len().max(4);
        format!("{frame:0digits$}")
    }

    fn values(&self, frame: u32) -> Vec<(&Number, f64)> {
        let of = |motion: &Motion| motion.values(self.all, frame);
        (self.motions.iter())
            .flat_map(|motion| motion.numbers().iter().zip(of(motion)))
            .collect()
    }

    /// The scene of a frame: the text with its numbers written in, read anew.
    pub fn scene(&self, frame: u32) -> Analysis {
        with_values(&self.source, &self.values(frame))
    }

    /// The scene of a frame, after a check that it reads with the frame's numbers. A scene with errors is returned,
    /// too: its findings tell them.
    ///
    /// # Errors
    ///
    /// A value is out of the range of all numbers, or the scene reads with other numbers than those written in.
    pub fn checked(&self, base: &Analysis, frame: u32) -> Result<Analysis, Complaint> {
        let values = self.values(frame);
        if let Some((number, _)) = values.iter().find(|(_, x)| !x.is_finite()) {
            let word = number.name.clone();
            return Err(Complaint::new("number-out-of-range").with("word", word));
        }
        let scene = with_values(&self.source, &values);
        match scene.is_sound() && !has_values(&scene, base, &values) {
            true => Err(Complaint::new("frame-reads-otherwise")),
            false => Ok(scene),
        }
    }
}

/// The frames that the arguments name, or else one for each row of the table. `Err` if the two differ in number.
fn range(frames: Option<Range>, table: Option<&Table>) -> Result<Range, Complaint> {
    let rows = table.map_or(0, |table| table.rows.len() as u64);
    match (frames, table) {
        (Some(frames), Some(_)) if u64::from(frames.count()) != rows => {
            Err(Complaint::new("rows-and-frames")
                .with("rows", Value::Count(rows))
                .with("frames", Value::Count(frames.count().into())))
        }
        (Some(frames), _) => Ok(frames),
        (None, _) => {
            let last = u32::try_from(rows.saturating_sub(1)).map_err(|_| too_many())?;
            Ok(Range { first: 0, last })
        }
    }
}

/// Complaints about numbers that two motions vary.
fn twice(motions: &[Motion]) -> Vec<Complaint> {
    let mut all: Vec<&Number> = motions.iter().flat_map(Motion::numbers).collect();
    all.sort_by_key(|number| number.span);
    let pairs = all.windows(2).filter(|pair| pair[0].span == pair[1].span);
    let complaint = |pair: &[&Number]| {
        let name = pair[0].name.clone();
        Complaint::new("set-twice").with("name", name)
    };
    pairs.map(complaint).collect()
}

/// The motion of a camera that goes around, or the motions of the two cameras of a stereo camera.
fn around(analysis: &Analysis, turn: Orbit) -> Result<Vec<Motion>, Error> {
    let scene = &analysis.scene;
    let pair = (records_of(analysis, turn.camera).into_iter())
        .find(|record| record.kind == RecordKind::StereoCamera);
    let ids: Vec<u32> = match pair {
        Some(pair) => (analysis.document.values(pair).iter().map(|&id| id as u32)).collect(),
        None => vec![turn.camera],
    };
    let mut cameras = Vec::new();
    for &id in &ids {
        let camera = scene.cameras[camera::number(scene, id)?];
        cameras.push((record(analysis, id)?, camera));
    }
    let all: Vec<Camera> = cameras.iter().map(|(_, camera)| *camera).collect();
    let centre = staging::centre(scene, analysis.bounds());
    let id = || turn.camera.to_string();
    let orbit = orbit::Orbit::of(&all, centre)
        .ok_or_else(|| Complaint::new("orbit-without-direction").with("id", id()))?;
    let motion = |(record, camera): (&Record, Camera)| {
        // The cameras of a slanted pair turn about one axis, and then the up direction of a camera turns, too.
        let count = match orbit.turned(&camera, 90.0).up == camera.up {
            true => POSITION_AND_DIRECTION,
            false => AND_UP,
        };
        let numbers = (0..count).filter_map(|i| Number::of(analysis, record, i));
        Motion::Around {
            numbers: numbers.collect(),
            camera: Box::new(camera),
            orbit,
            degrees: turn.degrees,
        }
    };
    Ok(cameras.into_iter().map(motion).collect())
}

/// The record with the numbers of a camera. `Err` if a transformation moves the camera, or it is given by a matrix.
fn record(analysis: &Analysis, id: u32) -> Result<&Record, Complaint> {
    let say = |message| Complaint::new(message).with("id", id.to_string());
    let records = records_of(analysis, id);
    let moves = |r: &&Record| {
        r.ty().family == Family::Transformation && r.kind != RecordKind::ProjectionMatrix
    };
    if let Some(record) = records.iter().copied().find(moves) {
        let start = analysis.document.id_token(record).start;
        let line = analysis.source.position(start).line;
        return Err(say("orbit-of-moved").with("line", line.to_string()));
    }
    let camera = |r: &&Record| r.kind == RecordKind::Camera;
    let record = records.iter().copied().find(camera);
    record.ok_or_else(|| say("orbit-of-projection"))
}
