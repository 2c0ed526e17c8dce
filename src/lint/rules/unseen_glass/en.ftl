W337 = the { $object } { $object-id } is invisible: it lets all light through and does not bend it
    .label = no light is reflected here, and none is lost
    .help = glass has a refractive index: `{ $line }`
    .fix = give it the refractive index of glass
W337-several = { $count ->
    [one] one object is invisible: it lets all light through and does not bend it
   *[other] { $count } objects are invisible: they let all light through and do not bend it
}
    .label = the first of them: no light is reflected here, and none is lost
    .help = { W337.help }
    .fix = give all of them the refractive index of glass
W337-called = the comment calls the { $object } { $object-id } glass, water or diamond, but it does not bend light
    .label = no refractive index goes with this
    .help = without a record -203 the refractive index is 1
    .fix = give it a refractive index: `{ $line }`
W337-called-several = comments call { $count ->
    [one] one object glass, water or diamond, but it does not bend light
   *[other] { $count } objects glass, water or diamond, but they do not bend light
}
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
