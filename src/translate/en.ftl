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
fidelity-light-above-white = { $percent } % of the picture is brighter than white; an image file clips that
fidelity-light-scale = with Declare=Light_Scale={ $scale } nothing is clipped, and all is { $times } times as bright
fidelity-no-light-above-white = nothing in a small picture is brighter than white
fidelity-overlooked = shadows and mirrored light that begin nearer than { $length } may be overlooked
fidelity-overlooked-behind = what is nearer than { $length } behind a surface may be overlooked
