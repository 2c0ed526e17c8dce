N603 = chybí světlo; od kamery svítí světlo s intenzitou 1
    .help = bodové světlo se zapisuje `ID -402 intenzita` a přesouvá se pomocí `ID -1 x y z`
