N603 = there is no light; a headlight of intensity 1 shines from the camera
    .help = a point light is written `ID -402 intensity` and moved with `ID -1 x y z`
