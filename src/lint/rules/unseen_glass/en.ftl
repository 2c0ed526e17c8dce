W337 = nothing of the { $object } { $object-id } can be seen: it lets all light through and does not bend it
    .label = no light is reflected here, and none is lost
    .help = glass has a refractive index: `{ $line }`
    .fix = give it the refractive index of glass
W337-several = nothing of { $count ->
    [one] one object
   *[other] { $count } objects
} can be seen: all light goes through and is not bent
    .label = the first of them: no light is reflected here, and none is lost
    .help = { W337.help }
    .fix = give all of them the refractive index of glass
W337-called = by its comment the { $object } { $object-id } is glass, water or diamond, but it does not bend light
    .label = no refractive index goes with this
    .help = without a record -203 the refractive index is 1
    .fix = give it a refractive index: `{ $line }`
W337-called-several = by their comments { $count ->
    [one] one object is
   *[other] { $count } objects are
} glass, water or diamond, but they do not bend light
    .label = the first of them: no refractive index goes with this
    .help = { W337-called.help }
    .fix = give all of them a refractive index, as in `{ $line }`
W337-unlike = the { $object } { $object-id } lets light through without bending it, unlike the { $other } { $other-id }
    .label = no refractive index goes with this
    .other = this has one
    .help = without a record -203 the refractive index is 1
    .fix = give it the same refractive index: `{ $line }`
W337-unlike-several = { $count ->
    [one] one object lets
   *[other] { $count } objects let
} light through without bending it, unlike the { $other } { $other-id }
    .label = the first of them: no refractive index goes with this
    .other = { W337-unlike.other }
    .help = { W337-unlike.help }
    .fix = give all of them the same refractive index
