N602 = chybí kamera; zvolí se pohled na celou scénu zprava, zepředu a shora
    .help = kamera se zapisuje `ID -501 x y z dx dy dz ux uy uz fovy`
