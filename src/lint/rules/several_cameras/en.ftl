W316 = { $count ->
    [one] there is { $count } camera and it is not selected
   *[other] there are { $count } cameras and none is selected
}: { $id }, the last one, takes the picture
    .label = this one is used
    .unused = { $other } is not used
    .help = select one with `ID -502 CAMERA`, or two for a stereo picture with `ID -503 LEFT RIGHT`
    .fix = select { $id }
