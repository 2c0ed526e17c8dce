//! Pictures of every form that PNG and JPEG files have, and what they show.

use jpeg_encoder::{ChromaSubsamplingMethod, ColorType, Encoder, SamplingFactor};

use crate::support::picture_file::{Colour, Png, SIZE, zlib};

/// A picture file, and what it shows.
pub struct File {
    pub name: String,
    pub bytes: Vec<u8>,
    /// Colours from 0 to 255, row by row from the top.
    pub shown: Vec<[f64; 3]>,
    /// By how much a decoder may differ, in the same numbers.
    pub most: f64,
}

/// What is drawn wherever a form can hold it: it changes slowly, so that JPEG keeps it.
fn colour(x: usize, y: usize) -> [u8; 3] {
    let (x, y) = (x as u8, y as u8);
    [20 + 12 * x, 30 + 14 * y, 220 - 8 * (x + y)]
}

fn each_pixel<T>(value: impl Fn(usize, usize) -> T) -> Vec<T> {
    let places = (0..SIZE[1]).flat_map(|y| (0..SIZE[0]).map(move |x| (x, y)));
    places.map(|(x, y)| value(x, y)).collect()
}

fn form<'a>(depth: u8, colour: Colour, chunks: &'a [(&'a str, Vec<u8>)]) -> Png<'a> {
    Png {
        depth,
        colour,
        chunks,
        interlaced: false,
    }
}

/// PNG of all colours and depths, whole and interlaced, with and without what says how to show the colours.
fn pngs() -> Vec<File> {
    let mut files = Vec::new();
    let mut add = |name: &str,
                   form: Png,
                   sample: &dyn Fn(usize, usize) -> Vec<u16>,
                   shown: &dyn Fn(usize, usize) -> [f64; 3]| {
        for interlaced in [false, true] {
            let form = Png { interlaced, ..form };
            files.push(File {
                name: format!("{name}{}.png", if interlaced { "_interlaced" } else { "" }),
                bytes: form.file(sample),
                shown: each_pixel(shown),
                most: 1e-6,
            });
        }
    };
    // From transparent to opaque.
    let alpha = |x: usize, most: u16| most / SIZE[0] as u16 * x as u16;
    for depth in [1, 2, 4, 8, 16] {
        let most = u32::from(u16::MAX >> (16 - depth));
        let value = |x: usize, y: usize| ((x * 7 + y * 5) as u32 * most / 134) as u16;
        let shown = |x, y| [f64::from(value(x, y)) * 255.0 / f64::from(most); 3];
        let grey = |x, y| vec![value(x, y)];
        add(
            &format!("grey{depth}"),
            form(depth, Colour::Grey, &[]),
            &grey,
            &shown,
        );
        // One of the greys is transparent.
        let clear = [("tRNS", value(3, 3).to_be_bytes().to_vec())];
        add(
            &format!("grey{depth}_key"),
            form(depth, Colour::Grey, &clear),
            &grey,
            &shown,
        );
        if depth < 16 {
            let palette: Vec<[u8; 3]> = (0..=most as usize)
                .map(|i| colour(i % 12, i % 11))
                .collect();
            let plain = [("PLTE", palette.concat())];
            let clear = [("PLTE", palette.concat()), ("tRNS", vec![0, 128])];
            let shown = |x, y| palette[usize::from(value(x, y))].map(f64::from);
            add(
                &format!("palette{depth}"),
                form(depth, Colour::Palette, &plain),
                &grey,
                &shown,
            );
            add(
                &format!("palette{depth}_clear"),
                form(depth, Colour::Palette, &clear),
                &grey,
                &shown,
            );
        }
        if depth >= 8 {
            let by = (most / 255) as u16;
            // In 16 bits a little more than in 8.
            let wide = |x, y| colour(x, y).map(|c| u16::from(c) * by + by / 3).to_vec();
            let shown =
                |x, y| colour(x, y).map(|c| f64::from(u16::from(c) * by + by / 3) / f64::from(by));
            let rgb_key: Vec<u8> = wide(4, 4).iter().flat_map(|s| s.to_be_bytes()).collect();
            let key = [("tRNS", rgb_key)];
            add(
                &format!("rgb{depth}"),
                form(depth, Colour::Rgb, &[]),
                &wide,
                &shown,
            );
            add(
                &format!("rgb{depth}_key"),
                form(depth, Colour::Rgb, &key),
                &wide,
                &shown,
            );
            let rgba = |x, y| [wide(x, y), vec![alpha(x, most as u16)]].concat();
            add(
                &format!("rgba{depth}"),
                form(depth, Colour::Rgba, &[]),
                &rgba,
                &shown,
            );
            let grey_alpha = |x, y| vec![value(x, y), alpha(x, most as u16)];
            let shown = |x, y| [f64::from(value(x, y)) * 255.0 / f64::from(most); 3];
            add(
                &format!("grey_alpha{depth}"),
                form(depth, Colour::GreyAlpha, &[]),
                &grey_alpha,
                &shown,
            );
        }
    }
    // What is said of colours does not change them: zpg takes all pictures as sRGB.
    let gamma = |g: u32| g.to_be_bytes().to_vec();
    let profile = [b"profile\0\0".to_vec(), zlib(&[0; 132])].concat();
    let white: Vec<u8> = [31270, 32900, 64000, 33000, 30000, 60000, 15000, 6000u32]
        .iter()
        .flat_map(|n| n.to_be_bytes())
        .collect();
    type Chunks<'a> = &'a [(&'a str, Vec<u8>)];
    let said: [(&str, Chunks); 6] = [
        ("linear", &[("gAMA", gamma(100_000))]),
        ("gamma", &[("gAMA", gamma(45_455))]),
        ("srgb", &[("sRGB", vec![0]), ("gAMA", gamma(45_455))]),
        ("primaries", &[("gAMA", gamma(55_556)), ("cHRM", white)]),
        ("profile", &[("iCCP", profile)]),
        (
            "background",
            &[("bKGD", vec![0, 255, 0, 0, 0, 0]), ("sBIT", vec![5, 6, 5])],
        ),
    ];
    let samples = |x, y| colour(x, y).map(u16::from).to_vec();
    let shown = |x, y| colour(x, y).map(f64::from);
    for (name, chunks) in said {
        add(name, form(8, Colour::Rgb, chunks), &samples, &shown);
    }
    files
}

/// JPEG in all the ways there are to store it.
fn jpegs() -> Vec<File> {
    let mut files = Vec::new();
    let [width, height] = SIZE.map(|n| n as u16);
    let rgb = each_pixel(colour).concat();
    let grey = each_pixel(|x, y| colour(x, y)[1]);
    let inks = |black: u8| {
        each_pixel(|x, y| {
            let [r, g, b] = colour(x, y).map(|c| 255 - c);
            [r, g, b, black]
        })
    };
    let colours = [
        ("rgb", ColorType::Rgb, rgb, 255.0),
        ("grey", ColorType::Luma, grey, 255.0),
        ("cmyk", ColorType::Cmyk, inks(0).concat(), 255.0),
        ("cmyk_black", ColorType::Cmyk, inks(80).concat(), 175.0),
        ("ycck", ColorType::CmykAsYcck, inks(80).concat(), 175.0),
    ];
    for (name, kind, data, lightest) in colours {
        let shown = each_pixel(|x, y| match kind {
            ColorType::Luma => [f64::from(colour(x, y)[1]); 3],
            _ => colour(x, y).map(|c| f64::from(c) * lightest / 255.0),
        });
        // Of four pixels with one chroma, blue is most off: by half a step of it each way, 1.772·0.564·((8 + 2.7)/2 +
        // (8 + 7.3)/2) = 13, where 2.7 and 7.3 are the steps of luma.
        for (way, most) in [
            ("", 4.0),
            ("_small", 4.0 + 13.0),
            ("_progressive", 4.0),
            ("_restarts", 4.0),
            ("_said", 4.0),
        ] {
            // The encoder makes CMYK coarser than black, which zpg does not read.
            if way == "_small" && kind == ColorType::Cmyk {
                continue;
            }
            let mut bytes = Vec::new();
            let mut encoder = Encoder::new(&mut bytes, 100);
            encoder.set_sampling_factor(SamplingFactor::F_1_1);
            match way {
                "_small" => {
                    encoder.set_sampling_factor(SamplingFactor::F_2_2);
                    encoder.set_chroma_subsampling_method(ChromaSubsamplingMethod::Average);
                }
                "_progressive" => encoder.set_progressive(true),
                "_restarts" => encoder.set_restart_interval(1),
                "_said" => {
                    encoder.add_icc_profile(&[0; 132]).unwrap();
                    // Held upside down.
                    let turned =
                        b"MM\0\x2a\0\0\0\x08\0\x01\x01\x12\0\x03\0\0\0\x01\0\x03\0\0\0\0\0\0";
                    encoder.add_exif_metadata(turned).unwrap();
                }
                _ => {}
            }
            encoder.encode(&data, width, height, kind).unwrap();
            files.push(File {
                name: format!("{name}{way}.jpg"),
                bytes,
                shown: match way {
                    // Turned by half a turn, the last pixel is the first one.
                    "_said" => shown.iter().rev().copied().collect(),
                    _ => shown.clone(),
                },
                most,
            });
        }
    }
    files
}

/// All forms, some of them under names that say something else or that programs stumble over. Names in a scene lead down
/// only.
pub fn files() -> Vec<File> {
    let mut files = pngs();
    files.extend(jpegs());
    let names = [
        ("rgb.jpg", "jpeg.png"),
        ("rgb8.png", "png.JPG"),
        ("grey.jpg", "none"),
        ("rgb16.png", "škola/měsíc.png"),
        ("cmyk.jpg", "šk%20ola/two words/a'b$c&<d>.jpeg"),
        ("palette4.png", &format!("{}.png", "x".repeat(240))),
        ("rgba8.png", &format!("{}.png", "ř".repeat(120))),
    ];
    for (form, name) in names {
        let file = files.iter().find(|file| file.name == form).unwrap();
        let file = File {
            name: name.to_owned(),
            bytes: file.bytes.clone(),
            shown: file.shown.clone(),
            most: file.most,
        };
        files.push(file);
    }
    files
}
