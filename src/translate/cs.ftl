### Co říkají zprávy o převodech tam, kde se něco doplňuje. Ostatní slova jsou ve phrases.cs.ftl.

fidelity-exact = přesně
fidelity-approximate = přibližně
fidelity-dropped = vynecháno
fidelity-exact-count = { $count ->
    [one] { $count } vlastnost (vyjmenuje ji --verbose)
    [few] { $count } vlastnosti (vyjmenuje je --verbose)
   *[other] { $count } vlastností (vyjmenuje je --verbose)
}
fidelity-within = na { $tolerance }
fidelity-cut = uříznuto na { $times }násobek mezí konečných částí a stěn kolem nich
fidelity-square-pixels = pixely budou čtvercové: zvolte --size { $width }x{ $height }
fidelity-made = { $exact }× { $name }, { fidelity-meshes }
fidelity-laid = { $name }, na { $exact ->
    [one] { $exact } přesném tvaru
   *[other] { $exact } přesných tvarech
} a na { $meshes ->
    [one] { $meshes } síti
   *[other] { $meshes } sítích
}
fidelity-meshes = { $meshes ->
    [one] { $meshes } síť
    [few] { $meshes } sítě
   *[other] { $meshes } sítí
}
fidelity-pictures = jen s kopií { $files } vedle { $path }
fidelity-rounding = o tom, která je vidět, rozhoduje zaokrouhlování, například u { $id }
fidelity-parallel = její paprsky budou rovnoběžné: posunou se o méně než { $pixels } pixelu
fidelity-volumes = u { $ids }: není dokázáno, že svůj objekt obsahují, nebo se objekt zapisuje beze jména
fidelity-depth = paprsky končí v hloubce { $depth }
fidelity-light-above-white = jasnějších než bílá je { $percent } % obrázku; soubor s obrázkem je ořízne
fidelity-light-scale = s volbou Declare=Light_Scale={ $scale } se nic neořízne, ale všechno má jen { $times }násobek jasu
fidelity-no-light-above-white = v malém obrázku není nic jasnější než bílá
fidelity-overlooked = stíny a odražené světlo, které začínají blíž než { $length }, se mohou ztratit
fidelity-overlooked-behind = co je za plochou blíž než { $length }, se může ztratit
