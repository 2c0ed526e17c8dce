### What reports of translations say, where they have places to fill. Other words stand in the source.

fidelity-exact = exact
fidelity-approximate = approximate
fidelity-dropped = dropped
fidelity-exact-count = { $count ->
    [one] { $count } feature (--verbose names it)
   *[other] { $count } features (--verbose names them)
}
fidelity-within = within { $tolerance }
fidelity-cut = cut to { $times } times the bounds of what has an end and of the faces around it
fidelity-square-pixels = pixels are made square: choose --size { $width }x{ $height }
fidelity-made = { $exact ->
    [one] { $exact } { $name }
   *[other] { $exact } { $name }s
}, { fidelity-meshes }
fidelity-laid = { $name }, on { $exact ->
    [one] { $exact } exact shape
   *[other] { $exact } exact shapes
} and { fidelity-meshes }
fidelity-meshes = { $meshes ->
    [one] { $meshes } mesh
   *[other] { $meshes } meshes
}
fidelity-pictures = only with a copy of { $files } beside { $path }
fidelity-rounding = which is seen is up to rounding, as in { $id }
fidelity-parallel = its rays are made parallel: off by less than { $pixels } of a pixel
fidelity-volumes = of { $ids }: not proved to hold their objects, or written without a name
fidelity-depth = rays end at depth { $depth }
limit-nodes-with-faces = faces in one place are looked for in { $most } nodes of an object
limit-nodes-offset = solids of more than { $most } nodes are not made larger or smaller where they touch others
limit-profile-points = profiles of more than { $most } points are not made larger or smaller where they touch others
limit-parts-levelled = in unions of more than { $most } parts faces in one plane are not put apart
limit-solids-settled = in unions of more than { $most } solids those that stand on each other are not looked for
limit-parts-shared = in unions of more than { $most } parts the same solids within them are not looked for
limit-parts-split = unions of more than { $most } parts in others are not written part by part
limit-parts-around = in unions of more than { $most } parts groups are not written part by part
limit-operands-flush = with more than { $most } tools or operands, none is made longer for another one
limit-operands-held = with more than { $most } operands of an intersection, those that hold others are not left out
limit-groups-compared = with more than { $most } groups in between, the first of two parts may not own their overlap
limit-parts-rewritten = where more than { $most } parts of many media overlap, light goes through the faces within them, too
limit-looks-of-skin = where a part ends in more than { $most } others that look different, the faces within belong to those
limit-modifications = operands that are modified more than { $most } times are written as they are
limit-triangle-pieces = where normals differ very much in length more than { $most } pieces of a triangle would be needed
limit-mirrors = with more than { $most } planes, only { $most } are treated as mirrors
fidelity-light-above-white = { $percent } % of the picture is brighter than white; an image file clips that
fidelity-light-scale = with Declare=Light_Scale={ $scale } nothing is clipped, and all is { $times } times as bright
fidelity-no-light-above-white = nothing in a small picture is brighter than white
fidelity-overlooked = shadows and mirrored light that begin nearer than { $length } may be overlooked
fidelity-overlooked-behind = what is nearer than { $length } behind a surface may be overlooked

heading-lights = lights
heading-camera = camera
heading-cameras = cameras
heading-drawn = what is drawn

pov-head = A scene for POV-Ray 3.7. For linear values, one ray through the middle of each pixel:
pov-channels = Some index differs by channel. Render three times, with Channel 0, 1 and 2, and keep
pov-channels-kept = red of the first picture, green of the second and blue of the third.
pov-eyes = A stereo pair: render with Eye 0 (left) and Eye 1 (right).
pov-light = All light is multiplied by this. Less than 1 keeps what an image file cannot hold: light above white.
pov-centre = The finished scene is moved by this to the origin, because far from it numbers are coarse.
pov-unit = The finished scene is scaled by this, because tolerances are absolute.
