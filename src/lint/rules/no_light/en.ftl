N603 = there is no light; an ambient light of 0.2 and a lamp of 0.8 above and to the left of the camera are added
    .help = a point light is written `ID -402 intensity` and moved with `ID -1 x y z`
