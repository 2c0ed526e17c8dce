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
limit-nodes-with-faces = stěny na jednom místě se hledají v { $most } uzlech objektu
limit-nodes-offset = tělesa o více než { $most } uzlech se tam, kde se dotýkají jiných, nezvětšují ani nezmenšují
limit-profile-points = profily o více než { $most } bodech se tam, kde se dotýkají jiných, nezvětšují ani nezmenšují
limit-parts-levelled = ve sjednoceních o více než { $most } částech se stěny v jedné rovině neoddalují
limit-solids-settled = ve sjednoceních o více než { $most } tělesech se nehledá, která na sobě stojí
limit-parts-shared = ve sjednoceních o více než { $most } částech se nehledají stejná tělesa uvnitř nich
limit-parts-split = sjednocení o více než { $most } částech uvnitř jiných se nezapisují po částech
limit-parts-around = ve sjednoceních o více než { $most } částech se skupiny nezapisují po částech
limit-operands-flush = z více než { $most } nástrojů nebo operandů se žádný kvůli jinému neprodlužuje
limit-operands-held = z více než { $most } operandů průniku se nevynechávají ty, které obsahují jiné
limit-groups-compared = je-li mezi dvěma částmi více než { $most } skupin, nemusí průnik patřit té první
limit-parts-rewritten = kde se překrývá více než { $most } částí z mnoha prostředí, prochází světlo i stěnami uvnitř nich
limit-looks-of-skin = kde část končí ve více než { $most } jiných, které vypadají různě, patří jim i stěny uvnitř
limit-modifications = operandy změněné více než { $most }krát se zapisují beze změny
limit-triangle-pieces = kde se délky normál velmi liší, bylo by potřeba více než { $most } dílů trojúhelníku
limit-mirrors = je-li rovin více než { $most }, za zrcadla se jich považuje jen { $most }
fidelity-light-above-white = jasnější než bílá je { $percent } % obrázku; soubor s obrázkem je ořízne
fidelity-light-scale = s volbou Declare=Light_Scale={ $scale } se nic neořízne, ale všechno má jen { $times }násobek jasu
fidelity-no-light-above-white = v malém obrázku není nic jasnější než bílá
fidelity-overlooked = stíny a odražené světlo, které začínají blíž než { $length }, se mohou ztratit
fidelity-overlooked-behind = co je za plochou blíž než { $length }, se může ztratit

heading-lights = světla
heading-camera = kamera
heading-cameras = kamery
heading-drawn = co se zobrazí

pov-head = Scéna pro POV-Ray 3.7. Lineární hodnoty a jeden paprsek středem každého pixelu dává:
pov-channels = Některý index lomu závisí na kanálu. Vykreslete scénu třikrát, s Channel 0, 1 a 2, a vezměte
pov-channels-kept = z prvního obrázku červenou, z druhého zelenou a ze třetího modrou.
pov-eyes = Stereoskopická dvojice: vykreslete ji s Eye 0 (levé oko) a Eye 1 (pravé oko).
pov-light = Tímto se násobí veškeré světlo. Hodnota pod 1 zachová, co soubor s obrázkem neunese: světlo jasnější než bílá.
pov-centre = O tolik se hotová scéna posune k počátku, protože daleko od něj jsou čísla hrubá.
pov-unit = Tolikrát se hotová scéna zvětší, protože tolerance jsou absolutní.
