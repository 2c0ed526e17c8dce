//! Which texts are scenes with mistakes, and which are something else: in whole, and cut anywhere.

use zpg::internals::analysis::{Analysis, repair};
use zpg::internals::diagnostics::Code;

use crate::rng::Rng;
use crate::support::seeds;

/// Scenes as people write them who have not yet learnt that types are numbers, or that comments need two signs.
const SCENES: &[&str] = &[
    "2 sphere <0,1,0>, 1\n3 plane 0 1 0 0\n4 union 2 3\n5 light 1\n9 camera 0 1 5 0 0 -1 0 1 0 45\n1 render 4 0\n",
    "2 koule 0 1 0 1\n3 rovina 0 1 0 0\n4 sjednocení 2 3\n5 světlo 1\n9 kamera 0 1 5 0 0 -1 0 1 0 45\n\
     1 vykreslení 4 0\n",
    "2 Box 0 0 0 1 1 1\n3 Sphere 1 1 1 0.5\n4 Difference 2 3\n5 Point light 1\n5 Move 3 4 5\n4 Color 1 0 0\n\
     1 Render 4 0\n",
    "2 kvádr 0 0 0 1 1 1\n3 koule 1 1 1 0.5\n4 rozdíl 2 3\n5 bodové světlo 1\n5 posunutí 3 4 5\n4 barva 1 0 0\n",
    "2 shpere 0 0 0 1\n3 torus 2 0.5\n4 unoin 2 3\n5 lamp 1\n6 colour 1 0 0\n4 assign 6 0\n",
    "10 barva 1 0 0\n11 barva 0 1 0\n2 anuloid 2 0.5\n2 otočení 30 1\n2 barva 0 0 1\n",
    "2 sphere(0, 0, 0, 1)\n3 box(0, 0, 0, 2, 2, 2)\n4 intersection(2, 3)\n1 scene(4, 0)\n",
    "2 cone 2 1 # red #\n# a heading #\n3 torus 2 1\n4 union 2 3 # all #\n5 ambient 0.3\n",
    "My first scene\nThis is the floor\n3 3 0 1 0 0\nThe ball\n2 11 0 1 0 1\nNow the light comes\n5 -402 1\n\
     and the camera\n9 -501 0 1 5 0 0 -1 0 1 0 45\n4 -101 2 3\n1 9999 4 0\n",
    "Domácí úkol 3\nJan Novák\npodlaha\n3 3 0 1 0 0\nkoule\n2 11 0 1 0 1\nsvětlo\n5 -402 1\nkamera\n\
     9 -501 0 1 5 0 0 -1 0 1 0 45\nspojení\n4 -101 2 3\nscéna\n1 9999 4 0\n",
    "Homework 3 of 5\nfloor 1\n3 plane 0 1 0 0\nball 2\n2 sphere 0 1 0 1\n4 union 2 3\nand all of it\n1 9999 4 0\n",
    "# only a comment\n",
    "# one\n# two\n# three\n",
];

/// What other tools write, and people.
const OTHERS: &[&str] = &[
    // C.
    "#include <stdio.h>\n\nint main(void) {\n    int sphere[] = {1, 2, 3};\n    for (int i = 0; i < 3; i++) {\n\
     \x20       printf(\"%d\\n\", sphere[i]);\n    }\n    return 0;\n}\n",
    // JSON.
    "{\"spheres\": [\n  {\"id\": 2, \"radius\": 1},\n  {\"id\": 3, \"radius\": 2}\n], \"render\": 9999}\n",
    // Markdown.
    "# A scene of balls\n\nA ball is a sphere.\nIt is round.\n\
     A sphere needs a centre and a radius, and a lamp beside it:\n\n\
     ```zpg\n2 11 0 0 0 1\n5 -402 1\n1 9999 2 0\n```\n\n\
     Write it.\nDraw it.\nLook at it.\n\nThen move it:\nit is a ball.\n",
    // A novel.
    "It was the best of times, it was the worst of times,\nit was the age of wisdom, it was the age of foolishness,\n\
     it was the epoch of belief, it was the season of Light,\nit was the season of Darkness, in 1775.\n",
    // Wavefront.
    "# cube.obj\no cube\nv 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nvn 0 0 1\nf 1 2 3\nf 1 3 4\n",
    // POV-Ray.
    "camera { location <0, 1, 5> look_at 0 }\nlight_source { <3, 5, 3>, 1 }\n\
     sphere { <0, 1, 0>, 1\n  pigment { rgb 1 }\n}\n\
     plane { y, 0 }\n",
    // YAML.
    "objects:\n  - sphere: [0, 0, 0, 1]\n  - plane: [0, 1, 0, 0]\nlight: 1\ncamera: {at: [0, 1, 5]}\n",
    // A table.
    "id,name,price,more,rest\n1,sphere,20,1,0\n2,box,30,0,1\n3,light,15,4,2\n4,camera,99,5,5\n5,plane,1,2,3\n",
    // Python.
    "import math\n\ndef sphere(x, y, z, r):\n    return 4 * math.pi * r ** 2\n\nprint(sphere(0, 0, 0, 1))\n",
    // A shell script without its first line.
    "set -e\nfor i in 1 2 3; do\n  render scene $i\ndone\necho done\n",
    // HTML.
    "<html>\n<body>\n<h1>Sphere</h1>\n<p>2 sphere 0 0 0 1</p>\n</body>\n</html>\n",
    // RIB.
    "Display \"a.tif\" \"file\" \"rgb\"\nProjection \"perspective\" \"fov\" 45\nWorldBegin\nTranslate 0 0 5\n\
     Sphere 1 -1 1 360\nWorldEnd\n",
    // A shopping list.
    "1 box of nails 5\n2 light bulbs 40 60\n3 cut boards 200 30 20\n4 plane tickets 99 99 120\n5 pounds of rice 1\n",
];

fn read(text: &str) -> Analysis {
    Analysis::new("scene.zpg", text.as_bytes().to_vec())
}

fn is_scene(text: &str) -> bool {
    let analysis = read(text);
    let others = analysis.findings().iter().filter(|d| d.code == Code::E014);
    let count = others.count();
    assert!(
        count == 0 || count == 1 && analysis.findings().len() == 1,
        "{text}"
    );
    count == 0
}

#[test]
fn scenes_with_mistakes_are_scenes() {
    for text in SCENES {
        assert!(is_scene(text), "{text}");
    }
}

#[test]
fn other_files_are_none() {
    for text in OTHERS {
        assert!(!is_scene(text), "{text}");
    }
    let png = b"\x89PNG\r\n\x1a\n\0\0\0\rIHDR\0\0\0\x01".to_vec();
    let png = Analysis::new("scene.zpg", png);
    assert!(png.findings().len() == 1 && !png.is_scene());
}

/// A text that is being typed is a scene from its first whole line on, and so is what is left of one.
#[test]
fn cuts_of_scenes_are_scenes() {
    for seed in seeds("CUTS", 0..300) {
        let mut rng = Rng::new(seed);
        // Those of words: of the others a cut may be prose alone.
        let text = SCENES[rng.below(8)];
        let lines: Vec<&str> = text.split_inclusive('\n').collect();
        let first = rng.below(lines.len() - 1);
        let last = first + 2 + rng.below(lines.len() - first - 1);
        let mut cut = lines[first..last].concat();
        if rng.chance(0.5) && last > first + 2 && last < lines.len() {
            let next: Vec<char> = lines[last].chars().collect();
            cut.extend(&next[..rng.below(next.len())]);
        }
        assert!(is_scene(&cut), "{cut}");
    }
}

#[test]
fn cuts_of_other_files_are_none() {
    for seed in seeds("CUTS", 0..300) {
        let mut rng = Rng::new(seed);
        let text = OTHERS[rng.below(OTHERS.len())];
        let chars: Vec<char> = text.chars().collect();
        // Three quarters of it.
        let length = chars.len() * 3 / 4;
        let first = rng.below(chars.len() - length + 1);
        let cut: String = chars[first..first + length].iter().collect();
        assert!(!is_scene(&cut), "{cut}");
    }
}

/// Every line of prose and every word has its proposal, and with all of them nothing is wrong.
#[test]
fn what_is_proposed_makes_scenes_of_them() {
    for text in SCENES {
        let mended =
            zpg::internals::analysis::fixing::to_fixed_point(read(text), true, Analysis::of);
        let left = repair::proposals(&mended.analysis);
        let errors: Vec<_> = left.iter().filter(|d| d.is_error()).collect();
        assert!(
            errors.is_empty(),
            "{text}\n{}\n{errors:?}",
            mended.analysis.source.text
        );
    }
}

/// What a proposal for one line makes of the lines before it moves no other line away from its own.
#[test]
fn every_word_has_its_proposal_at_once() {
    for text in &SCENES[..6] {
        let all = repair::proposals(&read(text));
        let mut errors = all.iter().filter(|d| d.is_error());
        assert!(errors.all(|d| !d.fixes.is_empty()), "{text}\n{all:?}");
    }
}
