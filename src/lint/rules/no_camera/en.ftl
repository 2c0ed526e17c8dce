N602 = there is no camera; the scene is framed automatically
    .help = a camera is written `ID -501 x y z dx dy dz ux uy uz fovy`
