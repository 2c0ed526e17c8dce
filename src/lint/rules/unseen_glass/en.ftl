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
