### The report of `zpg accuracy`.

accuracy-kind-edges = edges
accuracy-kind-light = cut light
accuracy-kind-numbers = rounding
accuracy-kind-facets = facets

accuracy-advice-none = No advice can be given: no measurement was finished.
accuracy-advice-wrong = The reference is wrong: an independent tracer in 71 digits comes to another colour in { $wrong } of { $pixels ->
    [one] { $pixels } pixel
   *[other] { $pixels } pixels
} (largest difference { $largest }, where white is 1, at { $places }). No advice is given. Please report this scene.
accuracy-advice-unchecked = The reference was not checked by the independent tracer: { $why }.
accuracy-advice-enough = The default settings are enough: no kind of error reaches { $goal } { accuracy-goal-unit } of an 8-bit picture (largest: { $kind }, { $error }).
accuracy-advice-enough-of = Of what was measured ({ $axes }), nothing reaches { $goal } { accuracy-goal-unit } of an 8-bit picture with the default settings (largest: { $kind }, { $error }). Other errors were not measured.
accuracy-goal-unit = { $unit ->
    [step] step
   *[steps] steps
}
accuracy-advice-limit = The largest error of this picture comes from { $kind }: with the default settings its pixels are off by { $error } steps (root mean square). A step is 1/255 of white, the smallest difference that an 8-bit picture can show.
accuracy-at-most = at most { $error }
accuracy-advice-set = With `{ $option }` this error is { $error } steps, and the picture takes { $times } times as long as with the default settings.
accuracy-advice-dearer = With `{ $option }` it is { $error } steps, but the picture takes { $times } times as long.
accuracy-advice-even = Even `{ $option }`, which takes { $times } times as long as the default settings, leaves an error of { $error } steps.
accuracy-advice-others = With the default settings each other kind of error is below { $error } steps.
accuracy-advice-others-of = With the default settings each other kind of error that was measured is below { $error } steps.
accuracy-advice-busy = The machine was too busy for exact times: other programs had the processor, so that the runs took { $times } times their CPU time. Close these programs and measure again before you rely on the times.
accuracy-price = for { $percent } % more time
accuracy-price-none = for no measurable time
accuracy-price-unsure = at a price that could not be measured
accuracy-advice-repair = In { $off } of the { $pixels ->
    [one] { $pixels } pixel
   *[other] { $pixels } pixels
} that were looked at, the cut light makes a difference of more than a step. `{ $option }` puts { $right } of them right { $price }.
accuracy-advice-save = `{ $option }` saves { $percent } % of the time, and no further pixel is off by more than a step.
accuracy-advice-no-change = No other setting of `zpg render` saves a tenth of the time without a visible change.
accuracy-depth-more = A depth of { $depth }, the default, cuts light that can be seen: `{ $option }` puts { $right } of { $off ->
    [one] { $off } pixel
   *[other] { $off } pixels
} right, and the picture takes { $times } times as long.
accuracy-depth-less = A depth of { $depth }, the default, is more than enough: `{ $option }` shows the same to the eye and { $price }.
accuracy-depth-same = A depth of { $depth }, the default, is more than enough, but less saves no time.
accuracy-depth-right = A depth of { $depth }, the default, is enough, and with less the picture changes.
accuracy-numbers-same = Doubles are enough here: double-double, which has twice as many digits, takes { $times } times as long and gives the same picture.
accuracy-numbers-unseen = Doubles are enough to the eye: double-double, which has twice as many digits, takes { $times } times as long and puts no pixel right.
accuracy-numbers-untimed = Doubles get no pixel wrong.
accuracy-numbers-report = Doubles are wrong in { $off ->
    [one] { $off } pixel
   *[other] { $off } pixels
}: please report this scene.
accuracy-numbers-f32 = Single precision { $off ->
    [0] shows the same
    [one] gets { $off } pixel wrong
   *[other] gets { $off } pixels wrong
} and { $price }.
accuracy-numbers-plain = The arithmetic of most ray tracers, which does not watch its own rounding (`plain-f64`, to compare with), { $off ->
    [0] gets nothing wrong here
    [one] gets { $off } pixel wrong
   *[other] gets { $off } pixels wrong
} and { $price }.
accuracy-saves-nothing = takes as long
accuracy-saves = saves { $percent } %
accuracy-costs = costs { $percent } % more
accuracy-time-unsure = takes a time that could not be measured

accuracy-skip-unasked = not asked for
accuracy-skip-light = nothing is mirrored and nothing lets light through: no light is cut
accuracy-skip-solver = no torus and no surface of revolution is drawn
accuracy-skip-levels = no geodesic sphere is drawn
accuracy-skip-glass = light goes through something, and a triangle has no inside
accuracy-skip-flat = everything is flat
accuracy-skip-patterns = patterns would come out in facets, too
accuracy-skip-mesh = no mesh could be made of it
accuracy-unfit-parts = there are too many parts
accuracy-unfit-deep = its operations are nested too deep
accuracy-unfit-facets = a geodesic sphere has too many facets
accuracy-unfit-matrix = a matrix has no inverse

accuracy-how-naive = whole pixels against an independent tracer in 71 digits
accuracy-how-light = half the depth and ten times the cutoff against all of it, on a quarter of the tiles
accuracy-how-edges = half of its samples against all of them
accuracy-cut-runs = some of five runs

accuracy-step-pilot = trying every setting once
accuracy-step-numbers = the reference in double-double, and its check
accuracy-step-light = the reference for cut light
accuracy-step-edges = the reference for edges
accuracy-step-errors = errors
accuracy-step-times = times
accuracy-step-objects = objects
accuracy-step-pictures = pictures

accuracy-effect-shadows = shadows
accuracy-effect-transparent-shadows = transparent shadows
accuracy-effect-reflection = reflection
accuracy-effect-refraction = refraction
accuracy-effect-dispersion = dispersion
accuracy-effect-textures = textures
accuracy-effect-smooth-normals = smooth normals

accuracy-title = What accuracy costs in time
accuracy-stopped = It was stopped before all was done.
accuracy-columns = { "  " }   CPU  × default     error     FLIP   off >1
accuracy-legend = ◆ the default
    ● worth its time: no other setting that was tried is both faster and more accurate
    ○ another setting is faster and as accurate, or more accurate and, within the noise, as fast
    CPU: seconds for the whole picture on one thread. Error: root mean square, in steps of 1/255 of white. FLIP: the difference that people see, from 0 to 1. Off >1: pixels that are off by more than a step.
    { $left ->
        [0] All settings that were tried are shown.
        [one] { $left } more setting is in accuracy.json.
       *[other] { $left } more settings are in accuracy.json.
    }
accuracy-same = same
accuracy-note-columns = Error: root mean square of the difference from the reference, in steps of 1/255. FLIP: how much of a difference people see, from 0 to 1. Pixels: those in which a channel is off by more than a step, and how many were looked at; slow settings are measured on fewer. Largest: the difference of the channel that is farthest off. On the front: nothing that was tried is both faster and more accurate. Adaptive: more samples until the estimated error of a pixel is below this. Cutoff: rays that count for less are dropped. `plain-f32` and `plain-f64` are there to compare with, and so are solvers and tessellations: `zpg render` has no such settings.
accuracy-note-objects = Where time and error are. A pixel counts for what its centre sees.
accuracy-note-effects = What each effect costs. Effects are taken out one at a time; they overlap, so that the shares do not add up.
accuracy-background = background
accuracy-time-by = time by what is seen first
accuracy-error-by = error by what is seen first
accuracy-taken-out = time by effect (these overlap)
accuracy-nothing = There is nothing to compare · { $why }
accuracy-not-run = not run
accuracy-cut = left out to keep the time
accuracy-noise = times are sure to ±{ $percent } %
accuracy-noise-busy = times are rough, since the machine was too busy
accuracy-share = errors were measured on { $percent } % of the pixels, in small tiles all over the picture
accuracy-reference-edges = edges are compared with { $samples ->
    [one] { $samples } sample
   *[other] { $samples } samples
} a pixel, which are off by { $error } steps themselves
accuracy-checked = an independent ray tracer with 71 digits computed { $pixels ->
    [one] { $pixels } pixel
   *[other] { $pixels } pixels
} again ({ $rays ->
    [one] { $rays } ray
   *[other] { $rays } rays
}): its colours { $largest ->
    [0] are the same
   *[other] differ by at most { $largest } of white (a step is 4e-3 of white)
}
accuracy-load = load of the machine { $before } before, { $after } after
accuracy-written = The page is { $path }

accuracy-panels-alt = Work-precision diagrams: error on x, time on y, both logarithmic, one panel for each kind of error
accuracy-head-edges = Edges
accuracy-head-light = Cut light
accuracy-head-numbers = Rounding
accuracy-head-facets = Facets
accuracy-sub-edges = how many samples a pixel has
accuracy-sub-light = depth of rays, cutoff of weights
accuracy-sub-numbers = which numbers, which solver
accuracy-sub-facets = flat pieces for curved surfaces
accuracy-own-error = reference’s own error
accuracy-none = none
accuracy-table-head = | setting | CPU time | × default | error | FLIP | off > 1 | |
accuracy-markdown-head = | setting | time, × default | error, steps | FLIP | pixels off > 1 step | largest, steps | |
accuracy-default = the default
accuracy-front = on the front
accuracy-recommended = recommended
accuracy-same-as = the same computation as { $other }
accuracy-below-reference = below the reference’s own error
accuracy-wrong-object = { $wrong ->
    [one] { $wrong } pixel sees another object
   *[other] { $wrong } pixels see another object
}
accuracy-ulps = distances off by { $ulps } units in the last place (median)
accuracy-uncertain = { $rays ->
    [one] { $rays } uncertain ray
   *[other] { $rays } uncertain rays
}
accuracy-tile-change = What else to set
accuracy-tile-numbers = Which numbers
accuracy-tile-sure = How sure
accuracy-section-panels = Each kind of error, on one scale
accuracy-note-panels = Left is more accurate, down is faster. Each panel changes one kind of setting and holds the others. Filled: nothing tried is both faster and more accurate. Ring: the default. Dashed: the goal. “none”: the same picture as the reference.
accuracy-section-table = What to set
accuracy-note-table = Error: root mean square in steps of 1/255 of the picture, with the interval that holds it for the whole picture with 95 %. Off > 1: pixels in which a channel differs by more than a step. CPU time: of the whole picture on one thread.
accuracy-more-rows = { $left ->
    [0] All settings that were tried are shown.
    [one] { $left } more setting that was tried is in accuracy.json.
   *[other] { $left } more settings that were tried are in accuracy.json.
}
accuracy-section-pictures = See it
accuracy-note-pictures = The part of the picture where the error of each kind is worst: with the default (for rounding: in single precision), with the most accurate setting that there is time for, and the difference.
accuracy-difference = difference × { $factor }; largest { $largest } steps; { $wrong ->
    [one] { $wrong } pixel
   *[other] { $wrong } pixels
} off by more than a step
accuracy-section-shares = Where time and error are
accuracy-note-shares = A pixel counts for what its centre sees. Effects are taken out one at a time; they overlap, so that the shares do not add up.
accuracy-objects-head = | seen first | pixels | time | error | µs a sample |
accuracy-effects-head = | taken out | time saved | rays saved | picture changes by |
accuracy-within-noise = within the noise
accuracy-map-time = Time of a sample, up to { $most } µs
accuracy-map-error = Error at edges, up to { $most } steps
accuracy-section-skipped = Not run, and why
accuracy-section-how = How this was measured
accuracy-note-how = Times are the least CPU time on one thread of several runs in shuffled order. The default was timed four times over: what these differ by is the noise. Errors are measured in doubles, on small tiles spread evenly over the full picture.
accuracy-shapes-head = | shape | how | lines | ns a line | wrong | median error | largest error | uncertain |

cost-camera = rays of the camera
cost-shadow = shadow rays
cost-reflection = mirrored rays
cost-refraction = rays that went through
cost-boxes = tests with boxes
cost-shapes = tests with shapes
cost-uncertain = rays decided in double-double
cost-phases = time
cost-objects = dearest of what is seen first
cost-effect = dearest effect, taken out alone
