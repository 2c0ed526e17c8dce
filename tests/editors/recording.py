"""Makes docs/pictures/editor.gif of the pictures that the test in VS Code takes.

usage, after tests/run: target/editors/venv/bin/pip install pillow, then
target/editors/venv/bin/python tests/editors/recording.py target/editors/pictures docs/pictures/editor.gif
"""

import sys
from pathlib import Path

from PIL import Image

# The names of the steps that are shown, and for how long, in milliseconds.
FRAMES = {
    "a-scene-is-opened": 700,
    "hints": 2200,
    "a-hover-with-a-picture": 2600,
    "a-fix-is-offered": 2200,
    "the-fix-is-applied": 1500,
    "completion": 2000,
    "the-preview-follows": 2600,
}

folder, out = map(Path, sys.argv[1:])
images = []
for name in FRAMES:
    (path,) = folder.glob(f"[0-9][0-9]-{name}.png")
    # Without the list of files and the bars around the window.
    image = Image.open(path).convert("RGB").crop((348, 36, 1272, 500))
    images.append(image.quantize(64, dither=Image.Dither.NONE))
images[0].save(out, save_all=True, append_images=images[1:], duration=list(FRAMES.values()), loop=0, optimize=True)
print(out.stat().st_size, "bytes")
