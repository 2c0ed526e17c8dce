N602 = there is no camera; the whole scene is seen from the right, the front and above
    .help = a camera is written `ID -501 x y z dx dy dz ux uy uz fovy`
